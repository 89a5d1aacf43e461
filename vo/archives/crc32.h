#pragma once

#include <cstdint>
#include <string_view>

namespace vo {

/// Returns the CRC-32 (that of PNG, zip and MCAP) of bytes behind others whose CRC-32 is `before`.
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

}  // namespace vo
