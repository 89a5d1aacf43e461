#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vo/text_files/toml_file.h"

namespace tools {

/// One table of an array `[[name]]` of a TOML file.
struct TableOfArray {
  std::string prefix;                 ///< `name.0.` of the first, which its keys begin with
  std::vector<vo::TomlValue> values;  ///< at least one, with their keys as in the file
};

/// Removes the values of the tables `[[name]]` from the values of a TOML file and returns them.
/// Throws vo::Error if `name` is something else there.
std::vector<TableOfArray> take_tables(std::string_view name, std::vector<vo::TomlValue>& values);

}  // namespace tools
