#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

namespace synth {

/// The n-th of points in [0, 1) x [0, 1) that fill the square evenly, however many are taken:
/// Roberts' R2 sequence from the start that `bits` say.
inline Eigen::Vector2f even_square(std::uint64_t bits, int n) {
  constexpr double kPlastic = 1.32471795724474602596;  // x^3 = x + 1
  constexpr float kBelowOne = 0x1.fffffep-1F;
  const double x = static_cast<double>(bits >> 32U) * 0x1p-32 + n / kPlastic;
  const double y = static_cast<double>(bits & 0xffffffffU) * 0x1p-32 + n / (kPlastic * kPlastic);
  return {std::min(kBelowOne, static_cast<float>(x - std::floor(x))),
          std::min(kBelowOne, static_cast<float>(y - std::floor(y)))};
}

}  // namespace synth
