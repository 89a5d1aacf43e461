#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "vo/core/hash.h"

namespace vo {

/// Random numbers indexed by pixel, so that they depend neither on the order of evaluation nor on
/// the number of threads. Each seed, purpose and frame has an independent field.
class RandomField {
 public:
  constexpr RandomField(std::uint64_t seed, std::uint64_t purpose, std::uint64_t frame)
      : key_(mixed(mixed(mixed(seed) ^ purpose) ^ frame)) {}

  /// Returns 64 random bits, independent for each pixel (u, v) and each index.
  constexpr std::uint64_t bits(int u, int v, int index = 0) const {
    const auto column = static_cast<std::uint32_t>(u);
    const auto row = static_cast<std::uint64_t>(static_cast<std::uint32_t>(v));
    return mixed(mixed(key_ ^ (row << 32U | column)) + static_cast<std::uint64_t>(index));
  }

  /// Returns a uniformly distributed number in [0, 1).
  constexpr double uniform(int u, int v, int index = 0) const {
    return static_cast<double>(bits(u, v, index) >> 11U) * 0x1p-53;
  }

  /// Returns a normally distributed number of mean 0 and variance 1 (Box & Muller from both halves
  /// of 64 bits; magnitudes are at most 6.7).
  double normal(int u, int v, int index = 0) const {
    const std::uint64_t value = bits(u, v, index);
    const double above_zero = (static_cast<double>(value >> 32U) + 1) * 0x1p-32;
    const double turn = static_cast<double>(value & 0xffffffffU) * 0x1p-32;
    return std::sqrt(-2 * std::log(above_zero)) * std::cos(2 * std::numbers::pi * turn);
  }

 private:
  std::uint64_t key_;
};

}  // namespace vo
