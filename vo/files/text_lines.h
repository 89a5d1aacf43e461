#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// A line of a text file that is neither empty nor a comment.
struct TextLine {
  std::string place;                ///< `file:line`, for messages
  std::vector<std::string> fields;  ///< split at blanks, tabs and commas
};

/// Returns the lines of a file without comments ('#' to the end of the line) and empty lines.
/// Accepts CRLF and a last line without newline.
std::vector<TextLine> read_text_lines(const std::filesystem::path& path);

/// Returns a field as a finite number; throws Error with the line's place if it is none.
double parse_number(const TextLine& line, std::size_t field);

}  // namespace vo
