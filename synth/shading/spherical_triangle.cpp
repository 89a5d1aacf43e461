#include "synth/shading/spherical_triangle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace synth {
namespace {

/// Returns the unit vector of the plane of two unit vectors that is across the first one, towards
/// the second.
Eigen::Vector3d across(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  return (second - first.dot(second) * first).normalized();
}

/// Returns the sine of an angle of 0 to pi of this cosine.
double sine_of(double cosine) {
  return std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

}  // namespace

/// The solid angle is that of van Oosterom & Strackee, The solid angle of a plane triangle, 1983.
SphericalTriangle::SphericalTriangle(const std::array<Eigen::Vector3f, 3>& corners) {
  std::transform(corners.begin(), corners.end(), corners_.begin(), [](const Eigen::Vector3f& c) {
    return Eigen::Vector3d(c.cast<double>().normalized());
  });
  const auto& [a, b, c] = corners_;
  const double volume = std::abs(a.dot(b.cross(c)));
  solid_angle_ = 2 * std::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// With corners a, b, c: the triangle of a, b and the point d on the arc from a to c has the wanted
/// part of the area, which is the sum of its angles less pi. The direction is on the arc from b to
/// d, whose points as near to b as a cosine says are a cap, of an area in proportion to 1 less it.
Eigen::Vector3f SphericalTriangle::direction(const Eigen::Vector2f& square) const {
  const auto& [a, b, c] = corners_;
  const double area = square.x() * solid_angle_;
  const double cos_alpha = std::clamp(across(a, b).dot(across(a, c)), -1.0, 1.0);
  const double sin_alpha = sine_of(cos_alpha);
  const double cos_ab = a.dot(b);
  // s and t are the sine and cosine of the area less the angle at a.
  const double s = std::sin(area) * cos_alpha - std::cos(area) * sin_alpha;
  const double t = std::cos(area) * cos_alpha + std::sin(area) * sin_alpha;
  const double u = t - cos_alpha;
  const double v = s + sin_alpha * cos_ab;
  const double below = (v * s + u * t) * sin_alpha;
  const double cos_ad =
      std::abs(below) > 0 ? std::clamp(((v * t - u * s) * cos_alpha - v) / below, -1.0, 1.0) : 1.0;
  const Eigen::Vector3d d = cos_ad * a + sine_of(cos_ad) * across(a, c);
  const double cos_bp = 1 - square.y() * (1 - d.dot(b));
  const Eigen::Vector3d direction = cos_bp * b + sine_of(cos_bp) * across(b, d);
  return direction.cast<float>();
}

}  // namespace synth
