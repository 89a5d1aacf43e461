#pragma once

#include <cstdint>
#include <initializer_list>

namespace vo {

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

}  // namespace vo
