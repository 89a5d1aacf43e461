#pragma once

#include <string>
#include <string_view>

namespace vo {

/// The bytes as a .gz file, without name and time: the same bytes give the same file.
std::string gzip(std::string_view bytes);

}  // namespace vo
