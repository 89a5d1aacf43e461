#include "vo/bootstrap/start_shutter.h"

#include <algorithm>
#include <cstddef>

namespace vo {
namespace {

/// Returns the velocity of a point at rest relative to a moving camera, times minus its inverse
/// depth: `ray` is the point times its inverse depth.
Eigen::Vector3d motion_of(const Vector6d& velocity, const Eigen::Vector3d& ray,
                          double inverse_depth) {
  return velocity.tail<3>().cross(ray) + inverse_depth * velocity.head<3>();
}

}  // namespace

std::vector<Vector6d> start_velocities(const StartViews& start,
                                       const std::vector<double>& timestamps) {
  constexpr double kMinSeconds = 1e-3;
  std::vector<SE3> T_frame_first{SE3()};
  for (const StartView& view : start.views) {
    T_frame_first.push_back(view.T_frame_first);
  }
  std::vector<Vector6d> velocities;
  for (std::size_t f = 0; f < T_frame_first.size(); ++f) {
    const std::size_t before = f == 0 ? 0 : f - 1;
    const std::size_t after = std::min(f + 1, T_frame_first.size() - 1);
    const double seconds = timestamps[after] - timestamps[before];
    const Vector6d motion = (T_frame_first[before] * T_frame_first[after].inverse()).log();
    velocities.push_back(seconds < kMinSeconds ? Vector6d::Zero() : Vector6d(motion / seconds));
  }
  return velocities;
}

void bend_pairs(const std::vector<Vector6d>& velocities, StartViews& start) {
  const int along = start.readout.axis == ReadoutAxis::columns ? 0 : 1;
  for (std::size_t f = 0; f < start.views.size(); ++f) {
    StartView& view = start.views[f];
    const SE3& T = view.T_frame_first;
    view.bend.clear();
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      const RayPair& pair = view.pairs[k];
      const double d = start.inverse_depth[view.places[k]];
      const Eigen::Vector3d ray = pair.first.homogeneous();
      const Eigen::Vector3d P = T.rotation() * ray + d * T.translation();
      const Eigen::Vector3d moved =
          pair.first_from_middle[along] * (T.rotation() * motion_of(velocities.front(), ray, d)) -
          pair.second_from_middle[along] * motion_of(velocities[f + 1], P, d);
      view.bend.emplace_back((moved.x() - P.x() / P.z() * moved.z()) / P.z(),
                             (moved.y() - P.y() / P.z() * moved.z()) / P.z());
    }
  }
}

}  // namespace vo
