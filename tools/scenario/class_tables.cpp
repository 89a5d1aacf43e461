#include "tools/scenario/class_tables.h"

#include <string>
#include <string_view>

#include "tools/scenario/table_array.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::string_view kTable = "class";

bool is_empty_array(const vo::TomlValue& value) {
  return value.type == vo::FieldType::reals && value.text.empty();
}

/// Adds the value of a table's key, within the table, to a class.
void add(std::string_view key, const vo::TomlValue& value, synth::SurfaceClass& one) {
  const std::string_view name = key.substr(0, key.find('.'));
  const bool is_list = name == "nodes" || name == "materials";
  vo::require(name == "name" || is_list, value.place, ": unknown key '", value.key,
              "'; expected name, nodes and materials of a class");
  if (is_list && is_empty_array(value)) {
    return;
  }
  vo::require(is_list == (key != name) && value.type == vo::FieldType::text, value.place, ": ",
              value.key, ": expected ", is_list ? "an array of texts" : "a text in quotes");
  if (is_list) {
    (name == "nodes" ? one.nodes : one.materials).push_back(value.text);
  } else {
    one.name = value.text;
  }
}

}  // namespace

std::vector<synth::SurfaceClass> take_classes(std::vector<vo::TomlValue>& values) {
  std::vector<synth::SurfaceClass> classes;
  for (const TableOfArray& table : take_tables(kTable, values)) {
    synth::SurfaceClass& one = classes.emplace_back();
    for (const vo::TomlValue& value : table.values) {
      add(std::string_view(value.key).substr(table.prefix.size()), value, one);
    }
    try {
      one.validate();
    } catch (const vo::Error& error) {
      vo::fail(table.values.front().place, ": ", error.what());
    }
  }
  return classes;
}

std::vector<synth::SurfaceClass> load_classes(const std::filesystem::path& file) {
  std::vector<vo::TomlValue> values = vo::read_toml(file);
  std::vector<synth::SurfaceClass> classes = take_classes(values);
  require_only_tables(kTable, !classes.empty(), values, file);
  return classes;
}

}  // namespace tools
