#include "tools/scenario/table_array.h"

#include <cstddef>
#include <utility>

#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns how many characters of a key are those of the array's element, `name.0.`; 0 if it is not
/// of one.
std::size_t prefix_length(std::string_view name, std::string_view key) {
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t number = name.size() + 1;
  const std::size_t end = key.find_first_not_of(kDigits, number);
  return end != std::string_view::npos && end > number && key[end] == '.' ? end + 1 : 0;
}

}  // namespace

std::vector<TableOfArray> take_tables(std::string_view name, std::vector<vo::TomlValue>& values) {
  std::vector<TableOfArray> tables;
  std::vector<vo::TomlValue> others;
  const std::string begin = vo::concat(name, ".");
  for (vo::TomlValue& value : values) {
    if (value.key != name && !value.key.starts_with(begin)) {
      others.push_back(std::move(value));
      continue;
    }
    const std::size_t length = value.key == name ? 0 : prefix_length(name, value.key);
    vo::require(length > 0, value.place, ": ", value.key, ": expected tables [[", name, "]]");
    const std::string prefix = value.key.substr(0, length);
    if (tables.empty() || tables.back().prefix != prefix) {
      tables.push_back({prefix, {}});
    }
    tables.back().values.push_back(std::move(value));
  }
  values = std::move(others);
  return tables;
}

void require_only_tables(std::string_view name, bool had_tables,
                         const std::vector<vo::TomlValue>& left,
                         const std::filesystem::path& file) {
  if (!left.empty()) {
    vo::fail(left.front().place, ": unknown key '", left.front().key, "'; expected tables [[", name,
             "]] alone");
  }
  vo::require(had_tables, file.string(), ": expected a table [[", name, "]], it has none");
}

}  // namespace tools
