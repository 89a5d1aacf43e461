#pragma once

#include <filesystem>
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

/// Throws vo::Error if tables `[[name]]` were not the only values of a file, of which `left` are
/// those that remain, or if there was no such table.
void require_only_tables(std::string_view name, bool had_tables,
                         const std::vector<vo::TomlValue>& left, const std::filesystem::path& file);

}  // namespace tools
