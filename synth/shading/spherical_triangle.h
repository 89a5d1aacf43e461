#pragma once

#include <array>

#include <Eigen/Core>

namespace synth {

/// What a triangle covers of the sphere of directions about a point.
class SphericalTriangle {
 public:
  /// The corners are relative to the point, in any unit.
  explicit SphericalTriangle(const std::array<Eigen::Vector3f, 3>& corners);

  float solid_angle() const { return static_cast<float>(solid_angle_); }  ///< sr

  /// Returns a unit direction, uniform over the solid angle if `square` is over its own: the first
  /// number divides the area by a great circle through one corner, the second an arc of this
  /// circle (Arvo, Stratified sampling of spherical triangles, 1995). Requires a solid angle of at
  /// least 1e-4 sr.
  Eigen::Vector3f direction(const Eigen::Vector2f& square) const;

 private:
  std::array<Eigen::Vector3d, 3> corners_;  ///< unit
  double solid_angle_;                      ///< sr
};

}  // namespace synth
