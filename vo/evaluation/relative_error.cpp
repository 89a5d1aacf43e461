#include "vo/evaluation/relative_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "vo/geometry/associate.h"

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
std::size_t nearest_by_bisection(std::span<const double> stamps, double timestamp) {
  std::size_t low = 0;
  std::size_t high = stamps.size();
  std::size_t nearest = 0;
  double least_difference = std::abs(stamps.front() - timestamp);
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const double difference = std::abs(stamps[middle] - timestamp);
    if (difference < least_difference) {
      least_difference = difference;
      nearest = middle;
    }
    if (stamps[middle] > timestamp) {
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

double median_interval(std::span<const double> stamps) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    intervals.push_back(stamps[i] - stamps[i - 1]);
  }
  return summarize(intervals).median;
}

/// Returns the intervals of evaluate_rpe.py, which leaves out those that end at the last pose.
std::vector<Interval> intervals_before_last(std::span<const double> stamps,
                                            const RpeInterval& interval) {
  std::vector<Interval> result;
  result.reserve(stamps.size());
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const std::size_t last = stamps.size() - 1;
    const std::size_t j =
        interval.unit == IntervalUnit::seconds
            ? nearest_by_bisection(stamps, stamps[i] + interval.length)
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

void add(IntervalErrors& errors, double begin, const SE3& error) {
  errors.timestamps.push_back(begin);
  errors.translations.push_back(error.translation().norm());
  errors.rotations_deg.push_back(error.angle() * 180 / std::numbers::pi);
}

RelativeErrors summarized(const IntervalErrors& errors) {
  return {summarize(errors.translations), summarize(errors.rotations_deg),
          errors.translations.size()};
}

/// The poses that evo associates: partners have equal indices.
struct AssociatedPoses {
  std::vector<std::size_t> truth;     ///< indices of the true poses
  std::vector<std::size_t> estimate;  ///< indices of the estimated poses
};

AssociatedPoses associated_poses(const Trajectory& truth, const Trajectory& estimate,
                                 const EvaluationOptions& options) {
  const bool estimate_is_shorter = estimate.size() <= truth.size();
  const Trajectory& shorter = estimate_is_shorter ? estimate : truth;
  const Trajectory& longer = estimate_is_shorter ? truth : estimate;
  const double offset = estimate_is_shorter ? options.time_offset : -options.time_offset;
  AssociatedPoses result;
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    const double timestamp = shorter[i].timestamp + offset;
    const std::size_t partner = nearest_earlier(longer, timestamp);
    if (std::abs(longer[partner].timestamp - timestamp) <= options.max_time_difference) {
      result.truth.push_back(estimate_is_shorter ? partner : i);
      result.estimate.push_back(estimate_is_shorter ? i : partner);
    }
  }
  return result;
}

}  // namespace

IntervalErrors interval_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options) {
  const std::vector<double> true_stamps = timestamps_of(truth);
  const double max_difference = 2 * median_interval(true_stamps);
  IntervalErrors errors;
  for (const Interval& interval :
       intervals_before_last(timestamps_of(estimate), options.interval)) {
    const double begin = estimate[interval.begin].timestamp + options.time_offset;
    const double end = estimate[interval.end].timestamp + options.time_offset;
    const Interval of_truth = {nearest_by_bisection(true_stamps, begin),
                               nearest_by_bisection(true_stamps, end)};
    if (std::abs(truth[of_truth.begin].timestamp - begin) <= max_difference &&
        std::abs(truth[of_truth.end].timestamp - end) <= max_difference) {
      const auto [P, Q] = motions(truth, of_truth, estimate, interval);
      add(errors, estimate[interval.begin].timestamp, P * Q.inverse());
    }
  }
  return errors;
}

RelativeErrors relative_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options) {
  return summarized(interval_errors_tum(truth, estimate, options));
}

RelativeErrors relative_errors_evo(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options) {
  const AssociatedPoses poses = associated_poses(truth, estimate, options);
  std::vector<double> stamps;
  for (const std::size_t i : poses.estimate) {
    stamps.push_back(estimate[i].timestamp);
  }
  const std::vector<Interval> intervals =
      options.interval.unit == IntervalUnit::seconds
          ? intervals_before_last(stamps, options.interval)
          : all_frame_intervals(stamps.size(), options.interval.length);
  IntervalErrors errors;
  for (const auto& [begin, end] : intervals) {
    const auto [P, Q] = motions(truth, {poses.truth[begin], poses.truth[end]}, estimate,
                                {poses.estimate[begin], poses.estimate[end]});
    add(errors, stamps[begin], Q.inverse() * P);
  }
  return summarized(errors);
}

}  // namespace vo
