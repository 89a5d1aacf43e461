#include "tools/train_edges/free_view.h"

#include <numbers>

namespace tools {
namespace {

constexpr double kMinDistance = 0.3;  // least distance to a surface, m
constexpr double kDegree = std::numbers::pi / 180;

/// Returns a unit direction in the world (y up) from angles in rad.
Eigen::Vector3d direction(double yaw, double pitch) {
  return {std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
}

bool sees_surfaces(const synth::SurfaceTracer& tracer, const vo::PinholeCamera& camera,
                   const vo::SE3& T_world_camera, double least_share) {
  const vo::DepthImage depth = tracer.trace(camera, T_world_camera).depth;
  const cv::Mat hit = depth > 0;
  double nearest = 0;
  cv::minMaxLoc(depth, &nearest, nullptr, nullptr, nullptr, hit);
  return cv::countNonZero(hit) >= least_share * static_cast<double>(depth.total()) &&
         nearest > kMinDistance;
}

/// Returns whether there are surfaces, none too near, on all sides but above, where a model may be
/// open.
bool is_free(const synth::SurfaceTracer& tracer, const Eigen::Vector3d& eye) {
  const vo::PinholeCamera probe = vo::PinholeCamera::from_horizontal_fov(8, 8, 90);
  for (const double yaw : {0.0, 90.0, 180.0, 270.0}) {
    const Eigen::Vector3d target = eye + direction(yaw * kDegree, 0);
    if (!sees_surfaces(tracer, probe, vo::look_at(eye, target, Eigen::Vector3d::UnitY()), 0.75)) {
      return false;
    }
  }
  const Eigen::Vector3d below = eye - Eigen::Vector3d::UnitY();
  return sees_surfaces(tracer, probe, vo::look_at(eye, below, Eigen::Vector3d::UnitX()), 1);
}

vo::SE3 random_gaze(const Eigen::Vector3d& eye, vo::Random& random) {
  const double yaw = random.uniform(0, 2 * std::numbers::pi);
  const double pitch = random.uniform(-35, 15) * kDegree;
  const double roll = random.uniform(-10, 10) * kDegree;
  const Eigen::Vector3d gaze = direction(yaw, pitch);
  const Eigen::Vector3d up = Eigen::AngleAxisd(roll, gaze) * Eigen::Vector3d::UnitY();
  return vo::look_at(eye, eye + gaze, up);
}

}  // namespace

std::optional<vo::SE3> free_view(const synth::SurfaceTracer& tracer,
                                 const vo::PinholeCamera& camera, vo::Random& random) {
  constexpr int kMaxTries = 20000;
  const Eigen::AlignedBox3d box = tracer.bounds();
  vo::PinholeCamera small = vo::PinholeCamera::from_horizontal_fov(32, 24, 60);
  small.fx = camera.fx * small.width / camera.width;
  small.fy = small.fx;
  for (int i = 0; i < kMaxTries; ++i) {
    Eigen::Vector3d eye;
    for (int axis = 0; axis < 3; ++axis) {
      eye[axis] = random.uniform(box.min()[axis], box.max()[axis]);
    }
    if (!is_free(tracer, eye)) {
      continue;
    }
    const vo::SE3 T_world_camera = random_gaze(eye, random);
    if (sees_surfaces(tracer, small, T_world_camera, 0.9)) {
      return T_world_camera;
    }
  }
  return std::nullopt;
}

}  // namespace tools
