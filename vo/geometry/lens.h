#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Core>

#include "vo/core/instruction_set.h"

namespace vo {

enum class DistortionModel { brown_conrady, kannala_brandt };

constexpr auto enum_names(DistortionModel) {
  return std::array{std::pair{DistortionModel::brown_conrady, "brown_conrady"},
                    std::pair{DistortionModel::kannala_brandt, "kannala_brandt"}};
}

/// Distortion: how a lens images the direction (x, y, 1) = (X / Z, Y / Z, 1), with r^2 = x^2 + y^2.
/// The default is a perfect lens.
///
/// Brown and Conrady, in OpenCV's meaning, with s = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 +
/// k5 r^4 + k6 r^6), of which k4 to k6 make OpenCV's rational model:
///     x_d = x s + 2 p1 x y + p2 (r^2 + 2 x^2), y_d = y s + p1 (r^2 + 2 y^2) + 2 p2 x y.
///
/// Kannala and Brandt (PAMI 2006), OpenCV's fisheye, Kalibr's `equidistant`: with a = atan r
///     (x_d, y_d) = (x, y) / r a (1 + k1 a^2 + k2 a^4 + k3 a^6 + k4 a^8).
/// Directions 85 deg or more off the axis are not imaged: depth along it needs less than 90 deg.
struct Distortion {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;
  double k4 = 0;
  double k5 = 0;
  double k6 = 0;
  DistortionModel model = DistortionModel::brown_conrady;

  bool is_zero() const {
    return model == DistortionModel::brown_conrady && k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 &&
           k3 == 0 && !is_rational();
  }

  /// Returns whether a lens of Brown and Conrady's model has a denominator.
  bool is_rational() const {
    return model == DistortionModel::brown_conrady && (k4 != 0 || k5 != 0 || k6 != 0);
  }

  /// Returns the direction (X / Z, Y / Z) imaged at `distorted`, by Newton's method, exact to 1e-12
  /// wherever `distort` is invertible. Not a number where a lens of Kannala and Brandt images
  /// nothing.
  Eigen::Vector2d remove(const Eigen::Vector2d& distorted) const;

  /// Throws Error where a coefficient does not belong to the model, or where a lens of Kannala and
  /// Brandt, or one with a denominator, folds over within `image_radius` of its axis, at a focal
  /// length of 1.
  void validate(double image_radius) const;
};

template <typename Visitor>
void visit_fields(Visitor& visit, Distortion& distortion) {
  visit("model", distortion.model, "what the coefficients mean; kannala_brandt is a fisheye");
  visit("k1", distortion.k1, "radial, r^2 (kannala_brandt: of the angle, k1 a^3)");
  visit("k2", distortion.k2, "radial, r^4 (k2 a^5)");
  visit("p1", distortion.p1, "tangential, brown_conrady alone");
  visit("p2", distortion.p2, "tangential, brown_conrady alone");
  visit("k3", distortion.k3, "radial, r^6 (k3 a^7)");
  visit("k4", distortion.k4, "radial, r^2 of the denominator (k4 a^9)");
  visit("k5", distortion.k5, "radial, r^4 of the denominator, brown_conrady alone");
  visit("k6", distortion.k6, "radial, r^6 of the denominator, brown_conrady alone");
}

/// Image of a direction at a focal length of 1, and its Jacobian by (x, y), which is symmetric.
template <typename Scalar>
struct DistortedPoint {
  Scalar x, y;
  Scalar dx_dx, dx_dy, dy_dy;
};

/// Adds the tangential terms to a radial factor s, of which ds / dx = slope x.
template <typename Scalar>
EDVO_INLINE DistortedPoint<Scalar> add_tangential(const Distortion& lens, Scalar x, Scalar y,
                                                  Scalar radial, Scalar slope) {
  const auto p1 = static_cast<Scalar>(lens.p1);
  const auto p2 = static_cast<Scalar>(lens.p2);
  const Scalar r2 = x * x + y * y;
  return {radial * x + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
          radial * y + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
          radial + slope * x * x + 2 * p1 * y + 6 * p2 * x, slope * x * y + 2 * p1 * x + 2 * p2 * y,
          radial + slope * y * y + 6 * p1 * y + 2 * p2 * x};
}

template <typename Scalar>
EDVO_INLINE DistortedPoint<Scalar> distort_brown_conrady(const Distortion& lens, Scalar x,
                                                         Scalar y) {
  const auto k1 = static_cast<Scalar>(lens.k1);
  const auto k2 = static_cast<Scalar>(lens.k2);
  const auto k3 = static_cast<Scalar>(lens.k3);
  const Scalar r2 = x * x + y * y;
  const Scalar radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const Scalar slope = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3));
  return add_tangential(lens, x, y, radial, slope);
}

/// The radial factor of a lens with a denominator at r^2, its derivative by r^2, and the
/// denominator.
template <typename Scalar>
struct RationalFactor {
  Scalar factor, slope, denominator;
};

template <typename Scalar>
EDVO_INLINE RationalFactor<Scalar> rational_factor(const Distortion& lens, Scalar r2) {
  const auto k1 = static_cast<Scalar>(lens.k1);
  const auto k2 = static_cast<Scalar>(lens.k2);
  const auto k3 = static_cast<Scalar>(lens.k3);
  const auto k4 = static_cast<Scalar>(lens.k4);
  const auto k5 = static_cast<Scalar>(lens.k5);
  const auto k6 = static_cast<Scalar>(lens.k6);
  const Scalar denominator = 1 + r2 * (k4 + r2 * (k5 + r2 * k6));
  const Scalar factor = (1 + r2 * (k1 + r2 * (k2 + r2 * k3))) / denominator;
  const Scalar above = k1 + r2 * (2 * k2 + r2 * 3 * k3);
  const Scalar below = k4 + r2 * (2 * k5 + r2 * 3 * k6);
  return {factor, (above - factor * below) / denominator, denominator};
}

template <typename Scalar>
EDVO_INLINE DistortedPoint<Scalar> distort_rational(const Distortion& lens, Scalar x, Scalar y) {
  const RationalFactor<Scalar> radial = rational_factor(lens, x * x + y * y);
  return add_tangential(lens, x, y, radial.factor, 2 * radial.slope);
}

/// Image radius at which a fisheye images an angle off its axis, rad, and its derivative by the
/// angle.
template <typename Scalar>
struct ImagedAngle {
  Scalar radius;
  Scalar slope;
};

template <typename Scalar>
EDVO_INLINE ImagedAngle<Scalar> image_angle(const Distortion& lens, Scalar angle) {
  const auto k1 = static_cast<Scalar>(lens.k1);
  const auto k2 = static_cast<Scalar>(lens.k2);
  const auto k3 = static_cast<Scalar>(lens.k3);
  const auto k4 = static_cast<Scalar>(lens.k4);
  const Scalar a2 = angle * angle;
  return {angle * (1 + a2 * (k1 + a2 * (k2 + a2 * (k3 + a2 * k4)))),
          1 + a2 * (3 * k1 + a2 * (5 * k2 + a2 * (7 * k3 + a2 * 9 * k4)))};
}

template <typename Scalar>
EDVO_INLINE DistortedPoint<Scalar> distort_kannala_brandt(const Distortion& lens, Scalar x,
                                                          Scalar y) {
  const Scalar r2 = x * x + y * y;
  Scalar radial = 1;                                                  // x_d / x
  Scalar slope = 2 * (static_cast<Scalar>(lens.k1) - Scalar(1) / 3);  // d radial / dx = slope x
  if (r2 > std::numeric_limits<Scalar>::epsilon()) {
    const Scalar r = std::sqrt(r2);
    const ImagedAngle<Scalar> imaged = image_angle(lens, std::atan(r));
    radial = imaged.radius / r;
    slope = (imaged.slope / (1 + r2) - radial) / r2;
  }
  return {radial * x, radial * y, radial + slope * x * x, slope * x * y, radial + slope * y * y};
}

template <typename Scalar>
inline DistortedPoint<Scalar> distort(const Distortion& lens, Scalar x, Scalar y) {
  if (lens.model == DistortionModel::kannala_brandt) {
    return distort_kannala_brandt(lens, x, y);
  }
  return lens.is_rational() ? distort_rational(lens, x, y) : distort_brown_conrady(lens, x, y);
}

}  // namespace vo
