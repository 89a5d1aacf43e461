#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tools {

/// Looks at the words of a command line before it is parsed: the first that is no command, and the
/// first option that its command does not have. Throws vo::Error of kind usage that names the word
/// and the nearest one that is known. `words` are without the program's name.
void require_known_words(const CLI::App& program, const std::vector<std::string>& words);

/// Turns `help COMMAND` into `COMMAND --help`, and `help` into `--help`.
std::vector<std::string> without_help_command(std::vector<std::string> words);

/// Turns `--json -`, which names stdout, into `--json` where that is a flag of the command.
std::vector<std::string> without_json_place(const CLI::App& program,
                                            std::vector<std::string> words);

}  // namespace tools
