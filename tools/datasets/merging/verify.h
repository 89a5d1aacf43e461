#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/core/progress.h"

namespace tools {

/// The file of a data set that has the SHA-256 of all others, as `sha256sum --check` reads it.
inline constexpr const char* kChecksums = "checksums.sha256";

/// What reading every file of a data set found.
struct Verification {
  std::size_t files = 0;
  std::uintmax_t bytes = 0;
  std::vector<std::string>
      problems;  ///< a sentence for each file that is missing, other or unknown
};

/// Reads every file of a data set and compares it with its checksum; a file without one is named,
/// too. Throws vo::Error where the folder holds no data set, and where a checksum names a file that
/// lies elsewhere.
Verification verify_dataset(const std::filesystem::path& folder, const vo::Progress& progress);

/// Returns what is wrong with a file; empty where it has that SHA-256.
std::string damage_of_file(const std::filesystem::path& file, const std::string& expected);

}  // namespace tools
