#include "tools/plot/table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <utility>

#include <nlohmann/json.hpp>

#include "vo/core/fields.h"

namespace tools {
namespace {

using Lines = std::vector<std::vector<std::string>>;

bool is_number(const TableCell& cell) {
  return std::holds_alternative<double>(cell);
}

/// Returns titles and cells as formatted text.
Lines shown(const Table& table) {
  Lines lines(1);
  for (const TableColumn& column : table.columns) {
    lines[0].push_back(column.name);
  }
  for (const std::vector<TableCell>& row : table.rows) {
    lines.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      lines.back().push_back(
          is_number(row[i]) ? format_decimals(std::get<double>(row[i]), table.columns[i].decimals)
                            : std::get<std::string>(row[i]));
    }
  }
  return lines;
}

bool is_number_column(const Table& table, std::size_t column) {
  return std::all_of(table.rows.begin(), table.rows.end(),
                     [&](const std::vector<TableCell>& row) { return is_number(row[column]); });
}

/// Returns the text as a field of CSV (RFC 4180): in quotes, its own doubled, where it must be.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

/// Returns the text as a cell of a Markdown table, which ends at `|` and at the line's end.
std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    cell += c == '|' ? "\\|" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  }
  return cell;
}

std::string csv_cell(const TableCell& cell) {
  if (!is_number(cell)) {
    return csv_text(std::get<std::string>(cell));
  }
  const double value = std::get<double>(cell);
  return std::isfinite(value) ? vo::format_real(value) : "";
}

}  // namespace

void Table::add_row(std::vector<TableCell> row) {
  assert(row.size() == columns.size());
  rows.push_back(std::move(row));
}

std::string format_decimals(double value, int decimals) {
  if (!std::isfinite(value)) {
    return "-";
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string as_csv(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    text += (i == 0 ? "" : ",") + csv_text(table.columns[i].name);
  }
  text += "\n";
  for (const std::vector<TableCell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += (i == 0 ? "" : ",") + csv_cell(row[i]);
    }
    text += "\n";
  }
  return text;
}

std::string as_markdown(const Table& table) {
  const Lines lines = shown(table);
  std::string rule = "|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    rule += is_number_column(table, i) ? "---:|" : "---|";
  }
  std::string text;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    text += "|";
    for (const std::string& cell : lines[l]) {
      text += " " + markdown_cell(cell) + " |";
    }
    text += l == 0 ? "\n" + rule + "\n" : "\n";
  }
  return text;
}

std::string as_text(const Table& table, const Colours& colours) {
  const Lines lines = shown(table);
  std::vector<std::size_t> widths(table.columns.size());
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto tone_of = table.columns[i].tone_of;
      const std::optional<Tone> tone = tone_of == nullptr ? std::nullopt : tone_of(line[i]);
      const std::string blanks(widths[i] - line[i].size(), ' ');
      const std::string cell = tone ? colours.paint(*tone, line[i]) : line[i];
      row += (i == 0 ? "" : "  ") + (is_number_column(table, i) ? blanks + cell : cell + blanks);
    }
    text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

nlohmann::ordered_json as_json(const Table& table) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const std::vector<TableCell>& row : table.rows) {
    nlohmann::ordered_json object;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& name = table.columns[i].name;
      if (!is_number(row[i])) {
        object[name] = std::get<std::string>(row[i]);
      } else if (std::isfinite(std::get<double>(row[i]))) {
        object[name] = std::get<double>(row[i]);
      } else {
        object[name] = nullptr;
      }
    }
    json.push_back(object);
  }
  return json;
}

}  // namespace tools
