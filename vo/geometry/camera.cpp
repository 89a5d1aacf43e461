#include "vo/geometry/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "vo/core/error.h"
#include "vo/geometry/projection.h"

namespace vo {
namespace {

// The limits of focal lengths, of either sign, and of the principal point, px: the directions of
// pixels and their squares stay within 32-bit floats.
constexpr double kLeastFocal = 1e-3;
constexpr double kGreatestFocal = 1e9;
constexpr double kFarthestCentre = 1e6;

/// Returns whether the direction that the lens images at a pixel, if there is one, is imaged there
/// again and the distortion is invertible around it.
bool is_invertible_at(const PinholeCamera& camera, double u, double v) {
  constexpr double kSamePixel = 1e-6;  // px
  const Eigen::Vector3d direction = camera.unproject({u, v}, 1);
  if (!direction.allFinite()) {
    return true;
  }
  if ((camera.project(direction) - Eigen::Vector2d(u, v)).norm() > kSamePixel) {
    return false;
  }
  const DistortedPoint<double> imaged = distort(camera.distortion, direction.x(), direction.y());
  return imaged.dx_dx > 0 && imaged.dx_dx * imaged.dy_dy > imaged.dx_dy * imaged.dx_dy;
}

/// Returns whether the distortion is invertible along the image border (and at the centre), where
/// it folds over first because it grows outwards.
bool has_invertible_border(const PinholeCamera& camera) {
  const double right = camera.width - 1;
  const double bottom = camera.height - 1;
  for (const double u : {0.0, right / 2, right}) {
    for (const double v : {0.0, bottom / 2, bottom}) {
      if (!is_invertible_at(camera, u, v)) {
        return false;
      }
    }
  }
  return true;
}

/// Returns the radius of the image corner farthest from the principal point, at a focal length of
/// 1.
double image_radius(const PinholeCamera& camera) {
  const double x = std::max(std::abs(camera.cx), std::abs(camera.width - 1 - camera.cx));
  const double y = std::max(std::abs(camera.cy), std::abs(camera.height - 1 - camera.cy));
  return std::hypot(x / camera.fx, y / camera.fy);
}

}  // namespace

PinholeCamera PinholeCamera::from_horizontal_fov(int width, int height, double fov_deg) {
  require(fov_deg > 0 && fov_deg < 180,
          "camera: expected a horizontal field of view between 0 and 180 deg, got ", fov_deg);
  const double focal_px = width / (2 * std::tan(fov_deg * std::numbers::pi / 360));
  return {.width = width,
          .height = height,
          .fx = focal_px,
          .fy = focal_px,
          .cx = (width - 1) / 2.0,
          .cy = (height - 1) / 2.0};
}

Eigen::Vector2d PinholeCamera::project(const Eigen::Vector3d& p_camera) const {
  const ImagedDirection<double> imaged = image_direction(
      Projection<double>(*this), p_camera.x() / p_camera.z(), p_camera.y() / p_camera.z());
  return {imaged.u, imaged.v};
}

Eigen::Vector3d PinholeCamera::unproject(const Eigen::Vector2d& pixel, double depth) const {
  Eigen::Vector2d image((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  if (!distortion.is_zero()) {
    image = distortion.remove(image);
  }
  return depth * image.homogeneous();
}

bool PinholeCamera::contains(const Eigen::Vector2d& pixel, double border_px) const {
  return pixel.x() >= border_px - 0.5 && pixel.x() < width - 0.5 - border_px &&
         pixel.y() >= border_px - 0.5 && pixel.y() < height - 0.5 - border_px;
}

PinholeCamera PinholeCamera::halved() const {
  PinholeCamera half = *this;
  half.width = width / 2;
  half.height = height / 2;
  half.fx = fx / 2;
  half.fy = fy / 2;
  half.cx = (cx + 0.5) / 2 - 0.5;
  half.cy = (cy + 0.5) / 2 - 0.5;
  return half;
}

PinholeCamera PinholeCamera::without_distortion() const {
  PinholeCamera ideal = *this;
  ideal.distortion = {};
  return ideal;
}

void require_image_size(int width, int height) {
  constexpr int kMaxSize = 16384;
  require(width > 0 && height > 0 && width <= kMaxSize && height <= kMaxSize,
          "camera: expected a size from 1x1 to ", kMaxSize, "x", kMaxSize, " px, got ", width, "x",
          height);
}

void PinholeCamera::validate() const {
  require_image_size(width, height);
  require(std::isfinite(fx) && std::isfinite(fy) && fx > 0 && fy != 0,
          "camera: expected fx above 0 and fy other than 0, got ", fx, ", ", fy);
  require(std::isfinite(cx) && std::isfinite(cy), "camera: expected finite cx and cy, got ", cx,
          ", ", cy);
  require(fx >= kLeastFocal && fx <= kGreatestFocal && std::abs(fy) >= kLeastFocal &&
              std::abs(fy) <= kGreatestFocal,
          "camera: expected focal lengths from ", kLeastFocal, " to ", kGreatestFocal, " px, got ",
          fx, ", ", fy);
  require(std::abs(cx) <= kFarthestCentre && std::abs(cy) <= kFarthestCentre,
          "camera: expected cx and cy within ", kFarthestCentre, " px, got ", cx, ", ", cy);
  distortion.validate(image_radius(*this));
  require(distortion.is_zero() || has_invertible_border(*this),
          "camera: the lens distortion folds over inside the image, expected coefficients that can "
          "be inverted up to its corners");
}

}  // namespace vo
