#include "vo/geometry/field_of_view.h"

namespace vo {

bool is_in_view(const PinholeCamera& camera, const Eigen::Vector3d& p_camera) {
  constexpr double kSameDirection = 1e-6;  // of (X / Z, Y / Z, 1), relative
  if (!(p_camera.z() > 0)) {
    return false;
  }
  const Eigen::Vector2d pixel = camera.project(p_camera);
  if (!camera.contains(pixel)) {
    return false;
  }
  const Eigen::Vector3d imaged = camera.unproject(pixel, p_camera.z());
  return (imaged - p_camera).norm() <= kSameDirection * p_camera.norm();
}

}  // namespace vo
