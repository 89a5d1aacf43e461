#include "tools/scenario/consistency.h"

#include <algorithm>
#include <cmath>
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

std::optional<vo::SE3> true_motion(const vo::Trajectory& truth, double earlier, double later) {
  const auto T_world_earlier = vo::pose_at(truth, earlier);
  const auto T_world_later = vo::pose_at(truth, later);
  if (!T_world_earlier || !T_world_later) {
    return {};
  }
  return T_world_earlier->inverse() * *T_world_later;
}

std::optional<double> squared_error(const vo::Trajectory& truth, double timestamp,
                                    const RelativePose& estimate) {
  const auto T_earlier_cur_true = true_motion(truth, estimate.timestamp, timestamp);
  if (!T_earlier_cur_true) {
    return {};
  }
  const vo::Vector6d error = (estimate.T_cur_earlier * *T_earlier_cur_true).log();
  return error.dot(estimate.covariance.ldlt().solve(error));
}

auto first_with_pose(const std::vector<vo::TrackingResult>& frames) {
  return std::find_if(frames.begin(), frames.end(), [](const vo::TrackingResult& frame) {
    return frame.status == vo::TrackingStatus::initialized;
  });
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
  const auto first = first_with_pose(frames);
  if (first == frames.end()) {
    return {};
  }
  return nees(truth, frames, [&](const vo::TrackingResult& frame) -> RelativePose {
    return {first->timestamp, frame.T_world_camera.inverse() * first->T_world_camera,
            frame.absolute_covariance};
  });
}

double greatest_sure_error(const vo::Trajectory& truth,
                           const std::vector<vo::TrackingResult>& frames) {
  double greatest = std::numeric_limits<double>::quiet_NaN();
  const auto first = first_with_pose(frames);
  for (auto frame = first; frame != frames.end(); ++frame) {
    if (frame->status != vo::TrackingStatus::tracked) {
      continue;
    }
    if (const auto motion = true_motion(truth, first->timestamp, frame->timestamp)) {
      const vo::SE3 T_first_cur = first->T_world_camera.inverse() * frame->T_world_camera;
      const double error = (T_first_cur.translation() - motion->translation()).norm();
      greatest = std::fmax(greatest, error);
    }
  }
  return greatest;
}

}  // namespace tools
