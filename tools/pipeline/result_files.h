#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/io/output.h"

namespace tools {

struct NamedBytes {
  std::string name;  ///< of a file, within a folder
  std::string bytes;
};

/// Either all are written or, when one of them would replace another result, none.
void write_results(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                   vo::ExistingOutput existing);

/// Throws vo::Error when it cannot be made.
void make_folder(const std::filesystem::path& folder);

}  // namespace tools
