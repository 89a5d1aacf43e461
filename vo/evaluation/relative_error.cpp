#include "vo/evaluation/relative_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vo {
namespace {

/// Motions of the camera over one interval, in the frame of the interval's start.
struct Motions {
  SE3 T_begin_end_estimate;  ///< P_i^-1 P_j
  SE3 T_begin_end_truth;     ///< Q_i^-1 Q_j
};

struct Interval {
  std::size_t begin;
  std::size_t end;
};

/// Returns the index of the nearest stamp. Which of two equally near ones is taken follows from the
/// order in which evaluate_rpe.py's bisection visits them.
std::size_t nearest_by_bisection(const Trajectory& trajectory, double timestamp) {
  std::size_t low = 0;
  std::size_t high = trajectory.size();
  std::size_t nearest = 0;
  double least_difference = std::abs(trajectory.front().timestamp - timestamp);
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const double difference = std::abs(trajectory[middle].timestamp - timestamp);
    if (difference < least_difference) {
      least_difference = difference;
      nearest = middle;
    }
    if (trajectory[middle].timestamp > timestamp) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return nearest;
}

/// Returns the index of the nearest stamp, the earlier of two equally near ones.
std::size_t nearest_earlier(const Trajectory& trajectory, double timestamp) {
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), timestamp,
                       [](const StampedPose& pose, double time) { return pose.timestamp < time; });
  if (after == trajectory.begin()) {
    return 0;
  }
  const auto before = after - 1;
  const bool before_is_nearer =
      after == trajectory.end() || timestamp - before->timestamp <= after->timestamp - timestamp;
  return static_cast<std::size_t>((before_is_nearer ? before : after) - trajectory.begin());
}

double median_interval(const Trajectory& trajectory) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    intervals.push_back(trajectory[i].timestamp - trajectory[i - 1].timestamp);
  }
  return summarize(intervals).median;
}

/// Returns the intervals of evaluate_rpe.py, which leaves out those that end at the last pose.
std::vector<Interval> intervals_before_last(const Trajectory& trajectory,
                                            const RpeInterval& interval) {
  std::vector<Interval> result;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::size_t last = trajectory.size() - 1;
    const std::size_t j =
        interval.unit == IntervalUnit::seconds
            ? nearest_by_bisection(trajectory, trajectory[i].timestamp + interval.length)
            : static_cast<std::size_t>(
                  std::min(static_cast<double>(i) + interval.length, static_cast<double>(last)));
    if (j != last) {
      result.push_back({i, j});
    }
  }
  return result;
}

/// Returns the intervals of evo_rpe --all_pairs, one from each pose over `frames` poses.
std::vector<Interval> all_frame_intervals(std::size_t poses, double frames) {
  std::vector<Interval> result;
  for (std::size_t i = 0; static_cast<double>(i) + frames < static_cast<double>(poses); ++i) {
    result.push_back({i, i + static_cast<std::size_t>(frames)});
  }
  return result;
}

Motions motions(const Trajectory& truth, const Interval& of_truth, const Trajectory& estimate,
                const Interval& of_estimate) {
  const auto motion = [](const Trajectory& trajectory, const Interval& interval) {
    return trajectory[interval.begin].T_world_camera.inverse() *
           trajectory[interval.end].T_world_camera;
  };
  return {motion(estimate, of_estimate), motion(truth, of_truth)};
}

RelativeErrors summarize_motions(const std::vector<SE3>& errors) {
  std::vector<double> translations;
  std::vector<double> rotations_deg;
  for (const SE3& error : errors) {
    translations.push_back(error.translation().norm());
    rotations_deg.push_back(error.angle() * 180 / std::numbers::pi);
  }
  return {summarize(translations), summarize(rotations_deg), errors.size()};
}

/// The poses that evo associates, partners at equal indices of both trajectories.
struct AssociatedPoses {
  Trajectory truth;
  Trajectory estimate;
};

AssociatedPoses associated_poses(const Trajectory& truth, const Trajectory& estimate,
                                 const EvaluationOptions& options) {
  const bool estimate_is_shorter = estimate.size() <= truth.size();
  const Trajectory& shorter = estimate_is_shorter ? estimate : truth;
  const Trajectory& longer = estimate_is_shorter ? truth : estimate;
  const double offset = estimate_is_shorter ? options.time_offset : -options.time_offset;
  AssociatedPoses result;
  for (const StampedPose& pose : shorter) {
    const double timestamp = pose.timestamp + offset;
    const StampedPose& partner = longer[nearest_earlier(longer, timestamp)];
    if (std::abs(partner.timestamp - timestamp) <= options.max_time_difference) {
      result.truth.push_back(estimate_is_shorter ? partner : pose);
      result.estimate.push_back(estimate_is_shorter ? pose : partner);
    }
  }
  return result;
}

}  // namespace

RelativeErrors relative_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options) {
  const double max_difference = 2 * median_interval(truth);
  std::vector<SE3> errors;
  for (const Interval& interval : intervals_before_last(estimate, options.interval)) {
    const double begin = estimate[interval.begin].timestamp + options.time_offset;
    const double end = estimate[interval.end].timestamp + options.time_offset;
    const Interval of_truth = {nearest_by_bisection(truth, begin),
                               nearest_by_bisection(truth, end)};
    if (std::abs(truth[of_truth.begin].timestamp - begin) <= max_difference &&
        std::abs(truth[of_truth.end].timestamp - end) <= max_difference) {
      const auto [P, Q] = motions(truth, of_truth, estimate, interval);
      errors.push_back(P * Q.inverse());
    }
  }
  return summarize_motions(errors);
}

RelativeErrors relative_errors_evo(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options) {
  const AssociatedPoses poses = associated_poses(truth, estimate, options);
  const std::vector<Interval> intervals =
      options.interval.unit == IntervalUnit::seconds
          ? intervals_before_last(poses.estimate, options.interval)
          : all_frame_intervals(poses.estimate.size(), options.interval.length);
  std::vector<SE3> errors;
  for (const Interval& interval : intervals) {
    const auto [P, Q] = motions(poses.truth, interval, poses.estimate, interval);
    errors.push_back(Q.inverse() * P);
  }
  return summarize_motions(errors);
}

}  // namespace vo
