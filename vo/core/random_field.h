#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "vo/core/hash.h"

namespace vo {

/// Random numbers by their place instead of their turn: the same in any order and on any number of
/// threads. Each seed and purpose has a stream of its own, each frame a part of it.
class RandomField {
 public:
  constexpr RandomField(std::uint64_t seed, std::uint64_t purpose, std::uint64_t frame)
      : key_(mixed(mixed(mixed(seed) ^ purpose) ^ frame)) {}

  /// Independent for each place (u, v) and each index.
  constexpr std::uint64_t bits(int u, int v, int index = 0) const {
    const auto column = static_cast<std::uint32_t>(u);
    const auto row = static_cast<std::uint64_t>(static_cast<std::uint32_t>(v));
    return mixed(mixed(key_ ^ (row << 32U | column)) + static_cast<std::uint64_t>(index));
  }

  /// In [0, 1).
  constexpr double uniform(int u, int v, int index = 0) const {
    return static_cast<double>(bits(u, v, index) >> 11U) * 0x1p-53;
  }

  /// Of mean 0 and variance 1 (Box & Muller, from both halves of 64 bits; at most 6.7).
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
