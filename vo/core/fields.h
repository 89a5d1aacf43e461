#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace vo {

/// An options struct lists its fields once, in a function beside it:
///
///     template <typename Visitor>
///     void visit_fields(Visitor& visit, PyramidOptions& options) {
///       visit("levels", options.levels, "each level has half the size of the one before");
///     }
///
/// Reading TOML, `--set key=value`, `--help`, the echo in a report and the check for unknown keys
/// all come from this list. An enumeration names its values in `enum_names(E)`, found by argument
/// dependent lookup, which returns an array of pairs (value, name).
enum class FieldType { boolean, integer, real, text, reals };

/// One field of an options struct, its value as text. `set` throws Error when the text is not a
/// value of the field; the message says what was expected.
struct Field {
  std::string key;   ///< dotted path from the outermost struct, `align.max_iterations`
  std::string help;  ///< meaning and unit
  FieldType type = FieldType::text;
  std::function<std::string()> get;
  std::function<void(std::string_view)> set;
};

template <typename E>
concept NamedEnum = std::is_enum_v<E> && requires(E value) {
  enum_names(value);
};

/// Returns the name of an enumeration's value, or "?" if it has none.
template <NamedEnum E>
std::string_view to_string(E value) {
  for (const auto& [candidate, name] : enum_names(value)) {
    if (candidate == value) {
      return name;
    }
  }
  return "?";
}

std::string format_real(double value);  ///< shortest text that reads back as the same double
double parse_real(std::string_view text);
std::int64_t parse_integer(std::string_view text);
bool parse_boolean(std::string_view text);

/// Parses numbers separated by commas, with or without blanks; throws Error unless there are
/// `count`.
std::vector<double> parse_reals(std::string_view text, std::size_t count);

/// Parses points x,y,z,x,y,z,...; throws Error unless the number of values is a multiple of three.
std::vector<Eigen::Vector3d> parse_points(std::string_view text);

/// Returns the index of `text` among the names; throws Error listing them if it is none of them.
std::size_t parse_choice(std::string_view text, const std::vector<std::string_view>& names);

/// Returns the names of an enumeration's values, in their order.
template <NamedEnum E>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (const auto& [value, name] : enum_names(E{})) {
    names.push_back(name);
  }
  return names;
}

template <NamedEnum E>
E parse_enum(std::string_view text) {
  return enum_names(E{})[parse_choice(text, names_of<E>())].first;
}

/// Returns the candidate with the least edit distance to `key`; empty when none is near.
std::string nearest_key(std::string_view key, const std::vector<std::string>& candidates);

/// Collects the fields of an options struct, nested structs included. The fields refer to the
/// struct, which must outlive them.
class FieldCollector {
 public:
  FieldCollector(std::vector<Field>& fields, std::string prefix)
      : fields_(fields), prefix_(std::move(prefix)) {}

  void operator()(const char* name, bool& value, const char* help);
  void operator()(const char* name, int& value, const char* help);
  void operator()(const char* name, std::uint64_t& value, const char* help);
  void operator()(const char* name, double& value, const char* help);
  void operator()(const char* name, std::string& value, const char* help);
  void operator()(const char* name, std::filesystem::path& value, const char* help);
  void operator()(const char* name, Eigen::Vector3d& value, const char* help);
  void operator()(const char* name, std::vector<Eigen::Vector3d>& value, const char* help);

  template <NamedEnum E>
  void operator()(const char* name, E& value, const char* help) {
    std::string choices = help;
    const char* separator = ": ";
    for (const auto& [candidate, choice] : enum_names(value)) {
      choices += std::string(separator) + choice;
      separator = " | ";
    }
    add(
        name, choices, FieldType::text, [&value] { return std::string(to_string(value)); },
        [&value](std::string_view text) { value = parse_enum<E>(text); });
  }

  /// Adds the fields of a nested options struct.
  template <typename Options>
  void operator()(const char* name, Options& options, const char*) {
    FieldCollector nested(fields_, prefix_ + name + ".");
    visit_fields(nested, options);
  }

 private:
  void add(const char* name, const std::string& help, FieldType type,
           std::function<std::string()> get, std::function<void(std::string_view)> set);

  std::vector<Field>& fields_;
  std::string prefix_;
};

/// Returns all fields of an options struct, their keys prefixed as given (`"sensor."`).
template <typename Options>
std::vector<Field> fields_of(Options& options, const std::string& prefix = "") {
  std::vector<Field> fields;
  FieldCollector collect(fields, prefix);
  visit_fields(collect, options);
  return fields;
}

/// Returns the current spelling of a field's key, which an earlier version may have spelt
/// otherwise.
std::string current_key(const std::string& key);

/// Returns the field of a key, in its current or an earlier spelling. Throws Error naming the
/// nearest known key when there is no such field.
Field& find_field(std::vector<Field>& fields, const std::string& key);

/// Sets one field from text; the Error names the key, what was expected and what was found.
void set_field(std::vector<Field>& fields, const std::string& key, std::string_view text);

}  // namespace vo
