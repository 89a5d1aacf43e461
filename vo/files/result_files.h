#pragma once

#include <filesystem>
#include <vector>

#include "vo/files/output.h"

namespace vo {

/// Either all are written or, when one of them would replace another result, none.
void write_results(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                   ExistingOutput existing);

/// Throws vo::Error when it cannot be made.
void make_folder(const std::filesystem::path& folder);

}  // namespace vo
