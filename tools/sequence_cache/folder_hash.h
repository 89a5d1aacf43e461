#pragma once

#include <filesystem>
#include <string>

namespace tools {

/// Returns a line `hash bytes name` for each file below a folder, sorted by name; the list that a
/// written folder has of its own files is left out.
std::string list_file_hashes(const std::filesystem::path& folder);

/// Returns a text on the first difference between the folder and such a list of its files; empty if
/// there is none.
std::string find_difference(const std::filesystem::path& folder, const std::string& listed);

}  // namespace tools
