#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// A line of a text file, valid while its TextFile is.
struct TextLine {
  const std::filesystem::path& file;
  std::size_t number = 0;                ///< from 1
  std::string_view text;                 ///< without its end
  std::vector<std::string_view> fields;  ///< split at blanks, tabs and commas

  std::string place() const;  ///< `file:line`, for messages
};

/// A text file of values in columns, kept as its bytes alone: a million lines need no more memory
/// than they need on disk.
class TextFile {
 public:
  /// Reads the file, without a byte order mark at its begin; throws Error as `read_file` does.
  explicit TextFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }

  /// Returns the number of lines, comments and empty ones included.
  std::size_t line_count() const;

  /// Returns the first line that `for_each_line` visits, without fields if there is none.
  TextLine first_line() const;

  /// Visits the lines in their order, without comments ('#' to the end of the line) and empty
  /// lines. Accepts CRLF and a last line without newline.
  void for_each_line(const std::function<void(const TextLine& line)>& visit) const;

  /// Visits all lines in their order, empty ones and comments, too, which are split as any other.
  void for_each_whole_line(const std::function<void(const TextLine& line)>& visit) const;

 private:
  std::filesystem::path path_;
  std::string text_;
};

/// Returns a field as a finite number; throws Error with the line's place if it is none.
double parse_number(const TextLine& line, std::size_t field);

}  // namespace vo
