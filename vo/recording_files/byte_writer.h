#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace vo {

/// Appends a number in little endian.
template <typename Number>
void append_number(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(Number));
}

/// Appends bytes behind their count, a number of 32 bits.
inline void append_counted(std::string& bytes, std::string_view part) {
  append_number(bytes, static_cast<std::uint32_t>(part.size()));
  bytes += part;
}

}  // namespace vo
