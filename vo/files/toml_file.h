#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "vo/core/fields.h"

namespace vo {

/// One value of a TOML file, its tables flattened to a dotted key: `[sensor] seed = 7` is
/// {"sensor.seed", "7"}. An array of numbers is its numbers with commas between.
struct TomlValue {
  std::string key;
  std::string text;
  FieldType type = FieldType::text;
  std::string place;  ///< `file:line`, for messages
};

/// All values of a TOML file in the order of the file. Throws Error with file, line and column for
/// what is not TOML.
std::vector<TomlValue> read_toml(const std::filesystem::path& path);

/// Sets the fields that the values name. Throws Error with file:line for a key that is not among
/// the fields (naming the nearest one) and for a value of another type.
void assign_fields(const std::vector<TomlValue>& values, std::vector<Field>& fields);

/// A text as a TOML string.
std::string quoted_toml(std::string_view text);

/// The fields as TOML that reads back to the same values.
std::string format_toml(const std::vector<Field>& fields);

}  // namespace vo
