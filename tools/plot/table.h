#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/colour/colour.h"

namespace tools {

struct TableColumn {
  std::string name;  ///< column name that ends in its unit
  int decimals = 0;  ///< decimals in text and Markdown; CSV and JSON are exact
  /// Returns the tone of a cell of this text in `as_text`, if any.
  std::optional<Tone> (*tone_of)(std::string_view cell) = nullptr;
};

using TableCell = std::variant<std::string, double>;

/// Named columns of equal length, for CSV, JSON, Markdown and plain text.
struct Table {
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;

  void add_row(std::vector<TableCell> row);  ///< appends a row with one cell per column
};

std::string as_csv(const Table& table);       ///< CSV; NaN is an empty cell
std::string as_markdown(const Table& table);  ///< Markdown table; NaN is a dash

/// Returns plain text with aligned columns, the cells in the tones of their columns; NaN is a dash.
std::string as_text(const Table& table, const Colours& colours = {});

nlohmann::ordered_json as_json(const Table& table);  ///< array with an object per row; NaN is null

std::string format_decimals(double value, int decimals);

}  // namespace tools
