#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace vo {

/// FNV-1a hash of 64 bits, to tell whether two contents are equal, on any machine. Not for
/// security.
class ContentHash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) {
      value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
    }
  }

  /// Adds the bytes of plain values, whose type must have no padding.
  template <typename T>
  void add_values(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// Returns a well-mixed hash of a 64-bit value (splitmix64), reproducible on any machine.
constexpr std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

/// Returns the hash `mixed(value)` as a number in [0, 1).
constexpr double mixed_uniform(std::uint64_t value) {
  return static_cast<double>(mixed(value) >> 11U) * 0x1p-53;
}

/// Returns a random number in [0, 1), a fixed function of its key: seed, purpose, index, ...
inline double random_uniform(std::initializer_list<std::uint64_t> key) {
  std::uint64_t hash = 0;
  for (const std::uint64_t part : key) {
    hash = mixed(hash + part);
  }
  return static_cast<double>(hash >> 11U) * 0x1p-53;
}

/// Returns the value as sixteen hexadecimal digits.
inline std::string to_hex(std::uint64_t value) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = text.size(); i-- > 0; value >>= 4) {
    text[i] = kDigits[value & 0xf];
  }
  return text;
}

}  // namespace vo
