#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace vo {

/// Returns the solid angle, sr, of each pixel of a row of an equirectangular image that is twice as
/// wide as it has rows.
inline double pixel_solid_angle(int row, int rows) {
  const double step = std::numbers::pi / rows;
  return step * (std::cos(row * step) - std::cos((row + 1) * step));
}

/// Camera that images all directions at once: columns are longitudes, rows latitudes, in equal
/// steps. Frame: x right, y down, z forward, as a pinhole's. With pixel (0, 0) the CENTRE of the
/// top-left pixel, a point (X, Y, Z) at the distance D is at
///     u = width (atan2(X, Z) / (2 pi) + 1/2) - 1/2,   v = height acos(-Y / D) / pi - 1/2:
/// forward is the image's middle, right is to the right of it, backward its left and right border,
/// which is a seam that nothing ends at, and the rows go from straight up to straight down. What
/// would be depth along an axis is the distance D here.
struct EquirectangularCamera {
  int width = 0;   ///< px, twice the height
  int height = 0;  ///< px

  /// Returns where a point is imaged, px, the column from -0.5 to width - 0.5; straight up and
  /// straight down in the middle column. Requires a point other than the camera's centre.
  Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const;

  /// Returns the point at a pixel, m in the camera frame, given its distance, m. Columns beyond the
  /// border go on behind the other one.
  Eigen::Vector3d unproject(const Eigen::Vector2d& pixel, double distance) const;

  /// Returns the derivatives of the ray of length 1 by column and row, 1/px, which are across it
  /// and each other.
  std::array<Eigen::Vector3d, 2> ray_derivatives(const Eigen::Vector2d& pixel) const;

  void validate() const;  ///< throws Error unless the image shows the whole sphere
};

template <typename Visitor>
void visit_fields(Visitor& visit, EquirectangularCamera& camera) {
  visit("width", camera.width, "px, twice the height");
  visit("height", camera.height, "px");
}

}  // namespace vo
