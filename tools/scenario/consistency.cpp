#include "tools/scenario/consistency.h"

#include <algorithm>
#include <optional>

#include <Eigen/Cholesky>

#include "vo/sequence_odometry/track_sequence.h"

namespace tools {
namespace {

// Percentiles of chi^2 with six degrees of freedom.
constexpr double kMedianOfChi2 = 5.348121;
constexpr double kP90OfChi2 = 10.644641;

/// A pose of a frame relative to an earlier one, as estimated.
struct RelativePose {
  double timestamp = 0;  ///< s, stamp of the earlier frame
  vo::SE3 T_cur_earlier;
  vo::Matrix6d covariance;  ///< of the left increment of T_cur_earlier
};

std::optional<double> squared_error(const vo::Trajectory& truth, double timestamp,
                                    const RelativePose& estimate) {
  const auto T_world_earlier = vo::pose_at(truth, estimate.timestamp);
  const auto T_world_cur = vo::pose_at(truth, timestamp);
  if (!T_world_earlier || !T_world_cur) {
    return {};
  }
  const vo::SE3 T_earlier_cur_true = T_world_earlier->inverse() * *T_world_cur;
  const vo::Vector6d error = (estimate.T_cur_earlier * T_earlier_cur_true).log();
  return error.dot(estimate.covariance.ldlt().solve(error));
}

/// Judges the poses that `pose_of` gives of the tracked frames.
template <typename PoseOf>
Nees nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames,
          const PoseOf& pose_of) {
  std::vector<double> squares;
  for (const vo::TrackingResult& frame : frames) {
    if (frame.status == vo::TrackingStatus::tracked) {
      if (const auto square = squared_error(truth, frame.timestamp, pose_of(frame))) {
        squares.push_back(*square);
      }
    }
  }
  return squares.empty() ? Nees{}
                         : Nees{.median = vo::percentile(squares, 0.5) / kMedianOfChi2,
                                .p90 = vo::percentile(squares, 0.9) / kP90OfChi2};
}

}  // namespace

Nees relative_nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames) {
  return nees(truth, frames, [](const vo::TrackingResult& frame) -> RelativePose {
    return {frame.reference_timestamp, frame.alignment.T_cur_ref, frame.alignment.covariance};
  });
}

Nees absolute_nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames) {
  const auto first = std::find_if(frames.begin(), frames.end(), [](const auto& frame) {
    return frame.status == vo::TrackingStatus::initialized;
  });
  if (first == frames.end()) {
    return {};
  }
  return nees(truth, frames, [&](const vo::TrackingResult& frame) -> RelativePose {
    return {first->timestamp, frame.T_world_camera.inverse() * first->T_world_camera,
            frame.absolute_covariance};
  });
}

}  // namespace tools
