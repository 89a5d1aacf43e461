#pragma once

#include <Eigen/Core>

namespace vo {

/// Lens distortion of Brown and Conrady in OpenCV's order and meaning; zero is a perfect lens.
/// With (x, y) = (X / Z, Y / Z) and r^2 = x^2 + y^2:
///     x_d = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2), y_d likewise.
struct Distortion {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;

  bool is_zero() const { return k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 && k3 == 0; }

  /// Inverse of `distort` by Newton's method, exact to 1e-12 wherever `distort` is invertible.
  Eigen::Vector2d remove(const Eigen::Vector2d& distorted) const;
};

/// Where a lens images the direction (x, y, 1), and the derivative by (x, y), which is symmetric.
template <typename Scalar>
struct DistortedPoint {
  Scalar x, y;
  Scalar dx_dx, dx_dy, dy_dy;
};

template <typename Scalar>
inline DistortedPoint<Scalar> distort(const Distortion& lens, Scalar x, Scalar y) {
  const auto k1 = static_cast<Scalar>(lens.k1);
  const auto k2 = static_cast<Scalar>(lens.k2);
  const auto k3 = static_cast<Scalar>(lens.k3);
  const auto p1 = static_cast<Scalar>(lens.p1);
  const auto p2 = static_cast<Scalar>(lens.p2);
  const Scalar r2 = x * x + y * y;
  const Scalar radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const Scalar slope = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3));  // d radial / dx = slope x
  return {radial * x + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
          radial * y + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
          radial + slope * x * x + 2 * p1 * y + 6 * p2 * x, slope * x * y + 2 * p1 * x + 2 * p2 * y,
          radial + slope * y * y + 6 * p1 * y + 2 * p2 * x};
}

/// Pinhole camera with lens distortion. Frame: x right, y down, z forward. Pixel (0, 0) is the
/// CENTRE of the top-left pixel, so the image spans [-0.5, width - 0.5) x [-0.5, height - 0.5).
/// A negative fy means a frame with y up (ICL-NUIM); nothing here takes its absolute value.
struct PinholeCamera {
  int width = 0;   ///< px
  int height = 0;  ///< px
  double fx = 0;   ///< px
  double fy = 0;   ///< px
  double cx = 0;   ///< px
  double cy = 0;   ///< px
  Distortion distortion;

  /// Square pixels, principal point in the middle. Throws Error unless 0 < fov_deg < 180.
  static PinholeCamera from_horizontal_fov(int width, int height, double fov_deg);

  Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const;  ///< needs p_camera.z() > 0
  Eigen::Vector3d unproject(const Eigen::Vector2d& pixel,
                            double depth) const;  ///< depth along z, m
  bool contains(const Eigen::Vector2d& pixel, double border_px = 0) const;

  PinholeCamera halved() const;              ///< the next pyramid level: cx' = (cx + 0.5) / 2 - 0.5
  PinholeCamera without_distortion() const;  ///< the same intrinsics, a perfect lens

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, Distortion& distortion) {
  visit("k1", distortion.k1, "radial, r^2");
  visit("k2", distortion.k2, "radial, r^4");
  visit("p1", distortion.p1, "tangential");
  visit("p2", distortion.p2, "tangential");
  visit("k3", distortion.k3, "radial, r^6");
}

template <typename Visitor>
void visit_fields(Visitor& visit, PinholeCamera& camera) {
  visit("width", camera.width, "px");
  visit("height", camera.height, "px");
  visit("fx", camera.fx, "focal length, px");
  visit("fy", camera.fy, "focal length, px; negative where the camera's y axis points up");
  visit("cx", camera.cx, "principal point, px; the centre of the top-left pixel is 0");
  visit("cy", camera.cy, "principal point, px; the centre of the top-left pixel is 0");
  visit("distortion", camera.distortion, "Brown-Conrady coefficients");
}

/// A colour camera with a depth image registered to it.
struct RgbdCamera {
  PinholeCamera pinhole;
  double depth_units_per_m = 5000;  ///< a 16-bit depth pixel divided by this is metres

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, RgbdCamera& camera) {
  visit_fields(visit, camera.pinhole);
  visit("depth_units_per_m", camera.depth_units_per_m, "value of a 16-bit depth pixel at 1 m");
}

}  // namespace vo
