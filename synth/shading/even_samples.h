#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

namespace synth {

/// Returns the n-th point of Roberts' R2 sequence, which fills [0, 1) x [0, 1) evenly however many
/// points are taken, from the start point that `bits` encode.
inline Eigen::Vector2f even_square(std::uint64_t bits, int n) {
  constexpr double kPlastic = 1.32471795724474602596;  // root of x^3 = x + 1
  constexpr float kBelowOne = 0x1.fffffep-1F;
  const double x = static_cast<double>(bits >> 32U) * 0x1p-32 + n / kPlastic;
  const double y = static_cast<double>(bits & 0xffffffffU) * 0x1p-32 + n / (kPlastic * kPlastic);
  return {std::min(kBelowOne, static_cast<float>(x - std::floor(x))),
          std::min(kBelowOne, static_cast<float>(y - std::floor(y)))};
}

}  // namespace synth
