#pragma once

#include <string>
#include <vector>

#include "vo/files/output.h"

namespace vo {

/// Returns a .zip archive of files, stored without compression and without times, so that equal
/// files give equal archives. Throws Error for more than 65 535 files or 4 GB, which a plain
/// archive cannot hold.
std::string zip(const std::vector<NamedBytes>& files);

}  // namespace vo
