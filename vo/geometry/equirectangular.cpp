#include "vo/geometry/equirectangular.h"

#include "vo/core/error.h"
#include "vo/geometry/camera.h"

namespace vo {

Eigen::Vector2d EquirectangularCamera::project(const Eigen::Vector3d& p_camera) const {
  const double longitude = std::atan2(p_camera.x(), p_camera.z());
  const double from_up = std::atan2(std::hypot(p_camera.x(), p_camera.z()), -p_camera.y());
  return {width * (longitude / (2 * std::numbers::pi) + 0.5) - 0.5,
          height * from_up / std::numbers::pi - 0.5};
}

Eigen::Vector3d EquirectangularCamera::unproject(const Eigen::Vector2d& pixel,
                                                 double distance) const {
  const double longitude = 2 * std::numbers::pi * ((pixel.x() + 0.5) / width - 0.5);
  const double from_up = std::numbers::pi * (pixel.y() + 0.5) / height;
  const double across = distance * std::sin(from_up);
  return {across * std::sin(longitude), -distance * std::cos(from_up),
          across * std::cos(longitude)};
}

std::array<Eigen::Vector3d, 2> EquirectangularCamera::ray_derivatives(
    const Eigen::Vector2d& pixel) const {
  const double longitude = 2 * std::numbers::pi * ((pixel.x() + 0.5) / width - 0.5);
  const double from_up = std::numbers::pi * (pixel.y() + 0.5) / height;
  const Eigen::Vector3d east(std::cos(longitude), 0, -std::sin(longitude));
  const Eigen::Vector3d south(std::cos(from_up) * std::sin(longitude), std::sin(from_up),
                              std::cos(from_up) * std::cos(longitude));
  return {2 * std::numbers::pi / width * std::sin(from_up) * east,
          std::numbers::pi / height * south};
}

void EquirectangularCamera::validate() const {
  require_image_size(width, height);
  require(width == 2 * height,
          "camera: expected an equirectangular image of the whole sphere, twice as wide as high, "
          "got ",
          width, "x", height, " px");
}

}  // namespace vo
