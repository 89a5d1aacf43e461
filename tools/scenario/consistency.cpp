#include "tools/scenario/consistency.h"

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

/// Calls `judge(first, frame)` with each tracked frame and the one that its map began with.
template <typename Judge>
void for_each_tracked(const std::vector<vo::TrackingResult>& frames, const Judge& judge) {
  const vo::TrackingResult* first = nullptr;
  for (const vo::TrackingResult& frame : frames) {
    if (frame.status == vo::TrackingStatus::initialized) {
      first = &frame;
    } else if (first != nullptr && frame.status == vo::TrackingStatus::tracked) {
      judge(*first, frame);
    }
  }
}

Nees nees_of(const std::vector<double>& squares) {
  return squares.empty() ? Nees{}
                         : Nees{.median = vo::percentile(squares, 0.5) / kMedianOfChi2,
                                .p90 = vo::percentile(squares, 0.9) / kP90OfChi2};
}

}  // namespace

Nees relative_nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames) {
  std::vector<double> squares;
  for (const vo::TrackingResult& frame : frames) {
    if (frame.status != vo::TrackingStatus::tracked) {
      continue;
    }
    const RelativePose pose{frame.reference_timestamp, frame.alignment.T_cur_ref,
                            frame.alignment.covariance};
    if (const auto square = squared_error(truth, frame.timestamp, pose)) {
      squares.push_back(*square);
    }
  }
  return nees_of(squares);
}

Nees absolute_nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames) {
  std::vector<double> squares;
  for_each_tracked(frames, [&](const vo::TrackingResult& first, const vo::TrackingResult& frame) {
    const RelativePose pose{first.timestamp, frame.T_world_camera.inverse() * first.T_world_camera,
                            frame.absolute_covariance};
    if (const auto square = squared_error(truth, frame.timestamp, pose)) {
      squares.push_back(*square);
    }
  });
  return nees_of(squares);
}

double greatest_sure_error(const vo::Trajectory& truth,
                           const std::vector<vo::TrackingResult>& frames) {
  double greatest = std::numeric_limits<double>::quiet_NaN();
  for_each_tracked(frames, [&](const vo::TrackingResult& first, const vo::TrackingResult& frame) {
    if (const auto motion = true_motion(truth, first.timestamp, frame.timestamp)) {
      const vo::SE3 T_first_cur = first.T_world_camera.inverse() * frame.T_world_camera;
      greatest = std::fmax(greatest, (T_first_cur.translation() - motion->translation()).norm());
    }
  });
  return greatest;
}

}  // namespace tools
