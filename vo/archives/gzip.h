#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vo {

/// Compresses the bytes to a .gz file without name and time, so that equal bytes give equal files.
std::string gzip(std::string_view bytes);

/// Returns whether the bytes begin as those of a .gz file do.
bool is_gzip(std::string_view bytes);

/// Returns the bytes that a .gz file holds. Throws Error if it is damaged, cut or holds more than
/// `max_bytes`.
std::string gunzip(std::string_view bytes, std::size_t max_bytes);

}  // namespace vo
