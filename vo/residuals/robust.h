#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace vo {

enum class RobustLoss { none, huber, tukey, student_t };

constexpr auto enum_names(RobustLoss) {
  return std::array{std::pair{RobustLoss::none, "none"}, std::pair{RobustLoss::huber, "huber"},
                    std::pair{RobustLoss::tukey, "tukey"},
                    std::pair{RobustLoss::student_t, "student_t"}};
}

/// Degrees of freedom of the t-distribution (Kerl, Sturm, Cremers, "Robust Odometry Estimation for
/// RGB-D Cameras", ICRA 2013).
constexpr float kStudentFreedom = 5;

/// Returns the natural logarithm of x >= 1 with an error below 2e-6. Unlike the library's it gives
/// identical bits on every machine and vectorizes in loops: ln m = 2 artanh((m - 1) / (m + 1)).
inline float natural_log(float x) {
  constexpr float kLn2 = 0.69314718F;
  constexpr std::uint32_t kMantissa = 0x007fffff;
  constexpr std::uint32_t kOne = 0x3f800000;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23U) - 127);
  const auto m = std::bit_cast<float>((bits & kMantissa) | kOne);
  const float s = (m - 1) / (m + 1);
  const float s2 = s * s;
  const float series = 1 + s2 * (1.0F / 3 + s2 * (1.0F / 5 + s2 * (1.0F / 7 + s2 * (1.0F / 9))));
  return exponent * kLn2 + 2 * s * series;
}

/// The loss rho(r) and the weight w(r) = rho'(r) / (2 r) of iteratively re-weighted least squares.
struct RobustValue {
  float weight;
  float loss;
};

/// Returns the weight and the loss of a residual, where k is the scale:
/// - none: r^2.
/// - huber: r^2 up to k and k (2 |r| - k) beyond (paper, Eq. 8, with |r| in its test).
/// - tukey: k^2 / 3 (1 - (1 - (r / k)^2)^3) up to k, constant beyond.
/// - student_t: (n + 1) k^2 ln(1 + r^2 / (n k^2)), n degrees of freedom.
template <RobustLoss kLoss>
inline RobustValue robust_value(float residual, float scale) {
  const float magnitude = std::abs(residual);
  const float square = residual * residual;
  if constexpr (kLoss == RobustLoss::huber) {
    const bool inside = magnitude <= scale;
    return {inside ? 1 : scale / magnitude, inside ? square : scale * (2 * magnitude - scale)};
  } else if constexpr (kLoss == RobustLoss::tukey) {
    const float k2 = scale * scale;
    const float share = magnitude < scale ? 1 - square / k2 : 0;
    return {share * share, k2 / 3 * (1 - share * share * share)};
  } else if constexpr (kLoss == RobustLoss::student_t) {
    const float n_k2 = kStudentFreedom * scale * scale;
    const float factor = kStudentFreedom + 1;
    return {factor * scale * scale / (n_k2 + square),
            factor * scale * scale * natural_log(1 + square / n_k2)};
  } else {
    return {1, square};
  }
}

inline RobustValue robust_value(RobustLoss loss, float residual, float scale) {
  switch (loss) {
    case RobustLoss::huber:
      return robust_value<RobustLoss::huber>(residual, scale);
    case RobustLoss::tukey:
      return robust_value<RobustLoss::tukey>(residual, scale);
    case RobustLoss::student_t:
      return robust_value<RobustLoss::student_t>(residual, scale);
    default:
      return robust_value<RobustLoss::none>(residual, scale);
  }
}

/// Returns d(w r) / dr over w, the curvature of the loss as a share of the weight: 1 for least
/// squares; less, or below 0, where the loss bends.
inline double curvature_share(RobustLoss loss, double residual, double scale) {
  const double square = residual * residual / (scale * scale);
  switch (loss) {
    case RobustLoss::huber:
      return square <= 1 ? 1 : 0;
    case RobustLoss::tukey:
      return square < 1 ? (1 - 5 * square) / (1 - square) : 0;
    case RobustLoss::student_t:
      return (kStudentFreedom - square) / (kStudentFreedom + square);
    default:
      return 1;
  }
}

/// Returns the scale at which a robust loss is 95 % as efficient as least squares on Gaussian
/// residuals of unit standard deviation (for the t-distribution, that standard deviation itself).
constexpr double efficient_scale(RobustLoss loss) {
  return loss == RobustLoss::huber ? 1.345 : loss == RobustLoss::tukey ? 4.685 : 1;
}

}  // namespace vo
