#pragma once

#include <optional>
#include <vector>

#include "vo/geometry/trajectory.h"

namespace tools {

/// One pose per frame, empty where the trajectory has none.
using FramePoses = std::vector<std::optional<vo::SE3>>;

/// Returns the trajectory's poses at the frames' times, within 0.1 ms.
FramePoses poses_of_frames(const vo::Trajectory& trajectory, const std::vector<double>& timestamps);

/// Returns poses interpolated along geodesics at the frames' times.
FramePoses interpolated_poses(const vo::Trajectory& trajectory,
                              const std::vector<double>& timestamps);

/// Errors of each frame, empty where a pose is missing. P is the estimate, Q the truth.
struct FrameErrors {
  std::vector<std::optional<double>> position_m;          ///< distance of `aligned` from the truth
  std::vector<std::optional<double>> rotation_deg;        ///< angle between `aligned` and the truth
  std::vector<std::optional<double>> step_translation_m;  ///< of (Q_i^-1 Q_j)^-1 P_i^-1 P_j
  std::vector<std::optional<double>> step_rotation_deg;  ///< rotation of (Q_i^-1 Q_j)^-1 P_i^-1 P_j
};

/// Returns position and rotation errors of `aligned` and step errors of `estimate`.
FrameErrors frame_errors(const FramePoses& truth, const FramePoses& estimate,
                         const FramePoses& aligned);

}  // namespace tools
