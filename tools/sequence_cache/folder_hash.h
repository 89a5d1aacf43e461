#pragma once

#include <filesystem>
#include <string>

namespace tools {

/// A line for each file below a folder, by name: `hash bytes name`.
std::string list_file_hashes(const std::filesystem::path& folder);

/// What the first file is that differs from such a list; empty when none does.
std::string find_difference(const std::filesystem::path& folder, const std::string& listed);

}  // namespace tools
