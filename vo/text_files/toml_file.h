#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "vo/core/fields.h"

namespace vo {

/// One value of a TOML file, its tables flattened to a dotted key: `[sensor] seed = 7` is
/// {"sensor.seed", "7"}. The text of an array is its numbers with commas between; those of texts
/// and of tables are flattened, too, each element's number from 0 being its key: the first
/// `[[class]] name = "chair"` is {"class.0.name", "chair"}.
struct TomlValue {
  std::string key;
  std::string text;
  FieldType type = FieldType::text;
  std::string place;  ///< `file:line`, for messages
};

/// Returns all values of a TOML file, each table sorted by key. Throws Error with file, line and
/// column for what is not TOML.
std::vector<TomlValue> read_toml(const std::filesystem::path& path);

/// One table of an array of tables, `[[camera]]`, its keys without the array's name.
struct TomlRecord {
  std::string place;  ///< `file:line`, for messages
  std::vector<TomlValue> values;
};

/// The values of a TOML file in which the tables of some arrays stand apart.
struct TomlRecords {
  std::vector<TomlValue> others;
  std::map<std::string, std::vector<TomlRecord>> arrays;  ///< of each name, in the file's order
};

/// Returns the values of a TOML file with arrays of tables of these names; those that the file
/// lacks are empty. Throws as `read_toml` does, and where a name is that of something else.
TomlRecords read_toml_records(const std::filesystem::path& path,
                              const std::vector<std::string>& names);

/// A table of a TOML file.
struct TomlTable {
  std::string key;    ///< dotted, from the outermost table
  std::string place;  ///< `file:line`, for messages
};

/// Returns all tables of a TOML file, those without a value, too, each before what it holds. Throws
/// as `read_toml` does.
std::vector<TomlTable> toml_tables(const std::filesystem::path& path);

/// Sets the fields that the values name. Throws Error with file:line for a key that is not among
/// the fields (naming the nearest one) and for a value of another type.
void assign_fields(const std::vector<TomlValue>& values, std::vector<Field>& fields);

/// Returns the text as a TOML string: quotes, backslashes and control characters are escaped, bytes
/// that are not UTF-8 become U+FFFD.
std::string quoted_toml(std::string_view text);

/// Returns a value as TOML that reads back to an equal one.
std::string format_toml(const TomlValue& value);

/// Returns the fields as TOML that reads back to equal values.
std::string format_toml(const std::vector<Field>& fields);

}  // namespace vo
