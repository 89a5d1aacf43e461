#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "vo/files/input.h"

namespace support {

/// The bytes of every file below a folder, by its path within the folder.
inline std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[entry.path().lexically_relative(folder).string()] = vo::read_file(entry.path());
    }
  }
  return files;
}

}  // namespace support
