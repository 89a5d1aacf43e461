#include "tools/watch/log_table.h"

#include <algorithm>
#include <sstream>

#include "vo/files/input.h"

namespace tools {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace

LogTable::LogTable(const std::filesystem::path& file) : file_(file) {
  std::istringstream text(vo::read_file(file));
  std::string line;
  std::getline(text, line);
  columns_ = cells_of(line);
  vo::require(has("timestamp"), file.string(),
              ": is no log of frames, expected a column named timestamp");
  while (std::getline(text, line)) {
    rows_.push_back(cells_of(line));
    vo::require(rows_.back().size() == columns_.size(), place(rows_.size() - 1), ": has ",
                rows_.back().size(), " cells, expected ", columns_.size());
  }
}

bool LogTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

double LogTable::number(std::size_t row, const std::string& column) const {
  try {
    return vo::parse_real(text(row, column));
  } catch (const vo::Error& error) {
    vo::fail(place(row), ": ", column, ": ", error.what());
  }
}

const std::string& LogTable::text(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  vo::require(found != columns_.end(), "there is no such column");
  return rows_.at(row)[static_cast<std::size_t>(found - columns_.begin())];
}

std::string LogTable::place(std::size_t row) const {
  constexpr std::size_t kHeaderAndFirst = 2;
  return vo::concat(file_.string(), ":", row + kHeaderAndFirst);
}

}  // namespace tools
