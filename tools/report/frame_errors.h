#pragma once

#include <optional>
#include <vector>

#include "vo/geometry/trajectory.h"

namespace tools {

/// One pose per frame, nothing where there is none.
using FramePoses = std::vector<std::optional<vo::SE3>>;

/// The trajectory's poses at the frames' times, at most a tenth of a millisecond apart.
FramePoses poses_of_frames(const vo::Trajectory& trajectory, const std::vector<double>& timestamps);

/// On the geodesic between the trajectory's poses.
FramePoses interpolated_poses(const vo::Trajectory& trajectory,
                              const std::vector<double>& timestamps);

/// Errors of each frame, nothing where a pose is missing.
struct FrameErrors {
  std::vector<std::optional<double>> position_m;          ///< distance from the truth
  std::vector<std::optional<double>> rotation_deg;        ///< angle to the truth
  std::vector<std::optional<double>> step_translation_m;  ///< of the motion since the frame before,
  std::vector<std::optional<double>> step_rotation_deg;   ///< E = (Q_i^-1 Q_j)^-1 P_i^-1 P_j
};

/// Of positions and rotations as the aligned estimate has them, of steps as they were tracked.
FrameErrors frame_errors(const FramePoses& truth, const FramePoses& estimate,
                         const FramePoses& aligned);

}  // namespace tools
