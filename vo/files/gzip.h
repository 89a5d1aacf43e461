#pragma once

#include <string>
#include <string_view>

namespace vo {

/// Compresses the bytes to a .gz file without name and time, so that equal bytes give equal files.
std::string gzip(std::string_view bytes);

}  // namespace vo
