#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tools {

/// Splits a command line into words as a POSIX shell does: at blanks, but for quotes and
/// backslashes. Nothing is expanded: a dollar sign in quotes is one. Throws vo::Error where a quote
/// stays open and where unquoted text would need a shell: pipes, redirections, substitutions.
std::vector<std::string> split_words(std::string_view text);

/// Returns the text quoted as one word of a shell's command.
std::string shell_quoted(const std::string& text);

/// Returns the indices of those words that a shell among the words runs as a script, as the third
/// word in `sh -c SCRIPT`.
std::vector<std::size_t> script_indices(const std::vector<std::string>& words);

}  // namespace tools
