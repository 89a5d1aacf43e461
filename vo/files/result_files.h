#pragma once

#include <filesystem>
#include <vector>

#include "vo/files/output.h"

namespace vo {

/// Writes all files into the folder, or none and throws Error when one of them would replace
/// another result.
void write_results(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                   const OutputPolicy& policy);

/// Makes the folder and its parents; throws vo::Error when that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace vo
