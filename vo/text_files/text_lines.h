#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// A line of a text file that is neither empty nor a comment, valid while it is visited.
struct TextLine {
  const std::filesystem::path& file;
  std::size_t number = 0;                ///< from 1
  std::vector<std::string_view> fields;  ///< split at blanks, tabs and commas

  std::string place() const;  ///< `file:line`, for messages
};

/// A text file of values in columns, kept as its bytes alone: a million lines need no more memory
/// than they need on disk.
class TextFile {
 public:
  /// Reads the file; throws Error as `read_file` does.
  explicit TextFile(std::filesystem::path path);

  /// Returns the number of lines, comments and empty ones included.
  std::size_t line_count() const;

  /// Visits the lines in their order, without comments ('#' to the end of the line) and empty
  /// lines. Accepts CRLF and a last line without newline.
  void for_each_line(const std::function<void(const TextLine& line)>& visit) const;

 private:
  std::filesystem::path path_;
  std::string text_;
};

/// Returns a field as a finite number; throws Error with the line's place if it is none.
double parse_number(const TextLine& line, std::size_t field);

}  // namespace vo
