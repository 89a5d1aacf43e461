#pragma once

#include <array>
#include <cmath>
#include <utility>

namespace vo {

enum class RobustLoss { none, huber };

constexpr auto enum_names(RobustLoss) {
  return std::array{std::pair{RobustLoss::none, "none"}, std::pair{RobustLoss::huber, "huber"}};
}

/// Weight w(r) of iteratively re-weighted least squares and loss rho(r), with w = rho'(r) / (2 r).
/// Huber's is r^2 up to the scale k and k (2 |r| - k) beyond (paper, Eq. 8, with |r| in its test).
struct RobustValue {
  float weight;
  float loss;
};

inline RobustValue robust_value(RobustLoss loss, float residual, float scale) {
  const float magnitude = std::abs(residual);
  if (loss == RobustLoss::none || magnitude <= scale) {
    return {1, residual * residual};
  }
  return {scale / magnitude, scale * (2 * magnitude - scale)};
}

}  // namespace vo
