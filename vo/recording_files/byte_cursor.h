#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "vo/core/error.h"

namespace vo {

/// Reads values from bytes in their order, numbers in little endian. Throws Error where the bytes
/// end before a value does; no memory is asked for.
class ByteCursor {
 public:
  explicit ByteCursor(std::string_view bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  bool at_end() const { return position_ == bytes_.size(); }

  /// Returns the next `count` bytes.
  std::string_view take(std::uint64_t count) {
    require(count <= left(), "ends early: expected ", count, " bytes at ", position_, ", got ",
            left());
    const std::string_view part = bytes_.substr(position_, count);
    position_ += count;
    return part;
  }

  template <typename Number>
  Number number() {
    Number value{};
    std::memcpy(&value, take(sizeof(Number)).data(), sizeof(Number));
    return value;
  }

  /// Returns bytes behind their count, a number of 32 bits.
  std::string_view counted() { return take(number<std::uint32_t>()); }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

}  // namespace vo
