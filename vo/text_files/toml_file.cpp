#include "vo/text_files/toml_file.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include <toml++/toml.h>

#include "vo/core/error.h"
#include "vo/core/utf8.h"
#include "vo/files/input.h"
#include "vo/text_files/toml_nesting.h"

namespace vo {
namespace {

using Path = std::filesystem::path;

/// Reads the text and the type of a TOML value that is no table.
class ValueReader {
 public:
  ValueReader(std::string key, std::string place)
      : key_(std::move(key)), place_(std::move(place)) {}

  TomlValue read(const toml::node& node) const {
    if (const auto* value = node.as_boolean()) {
      return make(value->get() ? "true" : "false", FieldType::boolean);
    }
    if (const auto* value = node.as_integer()) {
      return make(std::to_string(value->get()), FieldType::integer);
    }
    if (const auto* value = node.as_floating_point()) {
      return make(format_real(value->get()), FieldType::real);
    }
    if (const auto* value = node.as_string()) {
      require(value->get().find('\0') == std::string::npos, place_, ": ", key_,
              ": holds the character U+0000, expected a text without it");
      return make(value->get(), FieldType::text);
    }
    if (const auto* array = node.as_array()) {
      return make(numbers(*array), FieldType::reals);
    }
    fail(place_, ": ", key_, ": expected a truth value, a number, a text or an array of numbers");
  }

 private:
  TomlValue make(std::string text, FieldType type) const {
    return {key_, std::move(text), type, place_};
  }

  /// Returns the numbers of an array, or of nested arrays such as points, with commas between.
  std::string numbers(const toml::array& array) const {
    std::string text;
    for (const toml::node& element : array) {
      const auto* nested = element.as_array();
      const auto number = element.value<double>();
      require(nested != nullptr || (element.is_number() && number.has_value()), place_, ": ", key_,
              ": expected an array of numbers");
      text +=
          (text.empty() ? "" : ",") + (nested != nullptr ? numbers(*nested) : format_real(*number));
    }
    return text;
  }

  std::string key_;
  std::string place_;
};

std::string place_of(const toml::node& node, const Path& path) {
  return concat(path.string(), ":", node.source().begin.line);
}

/// Returns whether a node is an array of tables or of texts, which is no value of its own.
bool has_elements_with_keys(const toml::node& node) {
  const auto* array = node.as_array();
  return array != nullptr && (array->is_homogeneous(toml::node_type::table) ||
                              array->is_homogeneous(toml::node_type::string));
}

/// The values of a file, as they are found.
class Flattening {
 public:
  explicit Flattening(const Path& path) : path_(path) {}

  void add_table(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : table) {
      add(node, prefix + std::string(name.str()));
    }
  }

  std::vector<TomlValue> take() { return std::move(values_); }

 private:
  void add(const toml::node& node, const std::string& key) {
    const std::string place = place_of(node, path_);
    if (const auto* nested = node.as_table()) {
      add_table(*nested, key + ".");
    } else if (has_elements_with_keys(node)) {
      add_elements(*node.as_array(), key);
    } else {
      values_.push_back(ValueReader(key, place).read(node));
    }
  }

  void add_elements(const toml::array& array, const std::string& key) {
    for (std::size_t i = 0; i < array.size(); ++i) {
      const auto* table = array[i].as_table();
      require(table == nullptr || !table->empty(), place_of(array[i], path_), ": ", key,
              ": is an empty table, expected values");
      add(array[i], concat(key, ".", i));
    }
  }

  const Path& path_;
  std::vector<TomlValue> values_;
};

/// Returns all values of a table and of those within it.
std::vector<TomlValue> flattened(const toml::table& table, const Path& path) {
  Flattening flattening(path);
  flattening.add_table(table, "");
  return flattening.take();
}

/// Reads and parses a TOML file.
toml::table parsed(const Path& path) {
  const std::string text = read_file(path, kMaxConfigurationBytes);
  require_shallow_toml(text, path);
  try {
    return toml::parse(text, path.string());
  } catch (const toml::parse_error& error) {
    fail(path.string(), ":", error.source().begin.line, ":", error.source().begin.column, ": ",
         error.description());
  }
}

void list_tables(const toml::table& table, const std::string& prefix, const Path& path,
                 std::vector<TomlTable>& tables) {
  for (const auto& [name, node] : table) {
    if (const auto* nested = node.as_table()) {
      const std::string key = prefix + std::string(name.str());
      tables.push_back({key, place_of(node, path)});
      list_tables(*nested, key + ".", path, tables);
    }
  }
}

/// Returns whether a field takes a TOML value of this type: its own, or an integer for a real
/// field.
bool is_accepted(FieldType field, FieldType value) {
  return field == value || (field == FieldType::real && value == FieldType::integer);
}

std::string_view expectation(FieldType type) {
  switch (type) {
    case FieldType::boolean:
      return "true or false";
    case FieldType::integer:
      return "a whole number";
    case FieldType::real:
      return "a number";
    case FieldType::text:
      return "a text in quotes";
    case FieldType::reals:
      return "an array of numbers";
  }
  return "";
}

/// Returns a UTF-8 character as it stands within a TOML string.
std::string escaped_toml(std::string_view character) {
  constexpr char kDelete = 0x7F;
  const char first = character.front();
  if (character.size() > 1 || (first >= ' ' && first != kDelete)) {
    return (first == '"' || first == '\\' ? "\\" : "") + std::string(character);
  }
  std::array<char, 8> code{};
  std::snprintf(code.data(), code.size(), "\\u%04X", static_cast<unsigned>(first));
  return code.data();
}

std::string toml_text(const std::string& value, FieldType type) {
  switch (type) {
    case FieldType::text:
      return quoted_toml(value);
    case FieldType::reals:
      return "[" + value + "]";
    case FieldType::real:
      return value.find_first_of(".e") == std::string::npos ? value + ".0" : value;
    default:
      return value;
  }
}

}  // namespace

std::string quoted_toml(std::string_view text) {
  std::string result = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    result += length == 0 ? "\uFFFD" : escaped_toml(text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result + "\"";
}

std::vector<TomlValue> read_toml(const Path& path) {
  return flattened(parsed(path), path);
}

TomlRecords read_toml_records(const Path& path, const std::vector<std::string>& names) {
  toml::table document = parsed(path);
  TomlRecords result;
  for (const std::string& name : names) {
    std::vector<TomlRecord>& records = result.arrays[name];
    if (const toml::node* node = document.get(name)) {
      const toml::array* array = node->as_array();
      require(array != nullptr && array->is_homogeneous<toml::table>(), place_of(*node, path), ": ",
              name, ": expected tables [[", name, "]]");
      for (const toml::node& element : *array) {
        records.push_back({place_of(element, path), flattened(*element.as_table(), path)});
      }
      document.erase(name);
    }
  }
  result.others = flattened(document, path);
  return result;
}

std::vector<TomlTable> toml_tables(const Path& path) {
  std::vector<TomlTable> tables;
  list_tables(parsed(path), "", path, tables);
  return tables;
}

void assign_fields(const std::vector<TomlValue>& values, std::vector<Field>& fields) {
  for (const TomlValue& value : values) {
    try {
      const Field& field = find_field(fields, value.key);
      require(is_accepted(field.type, value.type), value.key, ": expected ",
              expectation(field.type), ", got ",
              value.type == FieldType::text ? quoted_toml(value.text) : value.text);
      set_field(fields, value.key, value.text);
    } catch (const Error& error) {
      throw Error(concat(value.place, ": ", error.what()), error.kind());
    }
  }
}

std::string format_toml(const std::vector<Field>& fields) {
  std::string text;
  for (const Field& field : fields) {
    text += concat(field.key, " = ", toml_text(field.get(), field.type), "\n");
  }
  return text;
}

std::string format_toml(const TomlValue& value) {
  return concat(value.key, " = ", toml_text(value.text, value.type), "\n");
}

}  // namespace vo
