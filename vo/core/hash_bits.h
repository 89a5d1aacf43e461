#pragma once

#include <cstdint>

namespace vo {

/// A well-mixed 64-bit value of any integer (splitmix64; Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014): randomness that is the same everywhere.
constexpr std::uint64_t hash_bits(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15U;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31U);
}

/// The same, in [0, 1).
constexpr double hash_uniform(std::uint64_t value) {
  return static_cast<double>(hash_bits(value) >> 11U) * 0x1p-53;
}

}  // namespace vo
