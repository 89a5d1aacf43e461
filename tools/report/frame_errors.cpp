#include "tools/report/frame_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tools {
namespace {

constexpr double kSameTime = 1e-4;  // s; timestamps with four decimals are equal within it

double angle_deg(const vo::SE3& T) {
  return T.log().tail<3>().norm() * 180 / std::numbers::pi;
}

}  // namespace

FramePoses poses_of_frames(const vo::Trajectory& trajectory,
                           const std::vector<double>& timestamps) {
  FramePoses poses;
  for (const double timestamp : timestamps) {
    const auto found = std::lower_bound(
        trajectory.begin(), trajectory.end(), timestamp - kSameTime,
        [](const vo::StampedPose& pose, double time) { return pose.timestamp < time; });
    poses.emplace_back();
    if (found != trajectory.end() && found->timestamp <= timestamp + kSameTime) {
      poses.back() = found->T_world_camera;
    }
  }
  return poses;
}

FramePoses interpolated_poses(const vo::Trajectory& trajectory,
                              const std::vector<double>& timestamps) {
  FramePoses poses;
  for (const double timestamp : timestamps) {
    poses.push_back(vo::pose_at(trajectory, timestamp));
  }
  return poses;
}

FrameErrors frame_errors(const FramePoses& truth, const FramePoses& estimate,
                         const FramePoses& aligned) {
  const std::size_t frames = truth.size();
  const std::vector<std::optional<double>> none(frames);
  FrameErrors errors{none, none, none, none};
  for (std::size_t i = 0; i < frames; ++i) {
    if (truth[i] && aligned[i]) {
      errors.position_m[i] = (truth[i]->translation() - aligned[i]->translation()).norm();
      errors.rotation_deg[i] = angle_deg(truth[i]->inverse() * *aligned[i]);
    }
    if (i > 0 && truth[i] && truth[i - 1] && estimate[i] && estimate[i - 1]) {
      const vo::SE3 T_error = (truth[i - 1]->inverse() * *truth[i]).inverse() *
                              (estimate[i - 1]->inverse() * *estimate[i]);
      errors.step_translation_m[i] = T_error.translation().norm();
      errors.step_rotation_deg[i] = angle_deg(T_error);
    }
  }
  return errors;
}

}  // namespace tools
