#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tools {

/// Work that tasks do in shares, each with a command of its own and in any order, and the command
/// that puts together what they made. Commands are words, without a shell.
struct SharedWork {
  std::string name;                ///< of the work, for people
  std::filesystem::path folder;    ///< in which the commands run
  std::string share_name;          ///< of what a share does: render, test
  std::vector<std::string> share;  ///< to which `--shard K/N` is added
  std::string finish_name;         ///< of the last step: merge, collect
  std::vector<std::string> finish;
  std::vector<std::vector<std::string>> local;  ///< what does all of it without shares, in order
  std::size_t shares = 1;                       ///< N
};

/// Returns the words quoted for a shell, those left as they are that need no quotes.
std::string shell_line(const std::vector<std::string>& words);

/// Returns a name of a job: what of the text are letters, digits, '.', '_' and '-', after `edvo-`.
std::string job_name(const std::string& text);

}  // namespace tools
