#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {

/// A log in CSV: names of columns, and a row for each frame.
class LogTable {
 public:
  /// Reads a file. Throws vo::Error naming the line that has not as many cells as there are
  /// columns, or the file where it has no column `timestamp`.
  explicit LogTable(const std::filesystem::path& file);

  std::size_t rows() const { return rows_.size(); }
  bool has(const std::string& column) const;

  /// Returns a cell as a number. Throws vo::Error naming file and line where it is none, or where
  /// there is no such column.
  double number(std::size_t row, const std::string& column) const;

  /// Returns a cell as a number, another value where there is no such column.
  double number_or(std::size_t row, const std::string& column, double otherwise) const {
    return has(column) ? number(row, column) : otherwise;
  }

  /// Returns a cell as the value of an enumeration. Throws as `number` does.
  template <vo::NamedEnum E>
  E choice(std::size_t row, const std::string& column) const {
    try {
      return vo::parse_enum<E>(text(row, column));
    } catch (const vo::Error& error) {
      vo::fail(place(row), ": ", column, ": ", error.what());
    }
  }

 private:
  const std::string& text(std::size_t row, const std::string& column) const;
  std::string place(std::size_t row) const;

  std::filesystem::path file_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace tools
