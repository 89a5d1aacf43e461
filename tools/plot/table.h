#pragma once

#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace tools {

struct TableColumn {
  std::string name;  ///< ends in its unit
  int decimals = 0;  ///< shown to people; CSV and JSON have all
};

using TableCell = std::variant<std::string, double>;

/// Named columns of equal length: one table for files, programs and people.
struct Table {
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;

  void add_row(std::vector<TableCell> row);  ///< one cell per column
};

std::string as_csv(const Table& table);              ///< NaN is an empty cell
std::string as_markdown(const Table& table);         ///< NaN is a dash, here and below
std::string as_text(const Table& table);             ///< columns aligned
nlohmann::ordered_json as_json(const Table& table);  ///< an object per row; NaN is null

std::string format_decimals(double value, int decimals);

}  // namespace tools
