#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/evaluation/evaluate.h"

namespace vo {
namespace {

constexpr double kGridStep = 0.005;   // s, well below the time in which hand-held motion changes
constexpr double kResolution = 1e-5;  // s
constexpr double kGoldenSection = 1 / std::numbers::phi;

struct Sample {
  double offset;
  double error;
};

/// Returns the poses whose time stays within the truth's at every offset, so that all offsets are
/// compared over the same poses.
Trajectory poses_inside(const Trajectory& truth, const Trajectory& estimate, double min_offset,
                        double max_offset) {
  Trajectory inside;
  for (const StampedPose& pose : estimate) {
    if (!truth.empty() && pose.timestamp + min_offset >= truth.front().timestamp &&
        pose.timestamp + max_offset <= truth.back().timestamp) {
      inside.push_back(pose);
    }
  }
  require(inside.size() >= 3, "cannot estimate a time offset: ", inside.size(), " of ",
          estimate.size(), " poses of the estimate lie within the truth's time span at every ",
          "offset from ", format_real(min_offset), " s to ", format_real(max_offset),
          " s, expected at least 3");
  return inside;
}

/// Returns the truth at the shifted times of the estimate's poses, with the estimate's stamps.
Trajectory interpolate(const Trajectory& truth, const Trajectory& estimate, double offset) {
  Trajectory result;
  for (const StampedPose& pose : estimate) {
    const double timestamp = std::clamp(pose.timestamp + offset, truth.front().timestamp,
                                        truth.back().timestamp);  // guards against rounding
    result.push_back({pose.timestamp, *pose_at(truth, timestamp)});
  }
  return result;
}

/// Returns offsets at most a grid step apart, the centre first and then by distance from it.
std::vector<double> grid(double centre, double range) {
  std::vector<double> offsets = {centre};
  const auto steps = static_cast<int>(std::ceil(range / kGridStep));
  for (int step = 1; step <= steps; ++step) {
    offsets.push_back(centre - range * step / steps);
    offsets.push_back(centre + range * step / steps);
  }
  return offsets;
}

Sample better(const Sample& a, const Sample& b) {
  return b.error < a.error ? b : a;
}

/// Searches by golden section between `low` and `high`; returns the best sample so far unless it
/// finds a better one.
Sample refine(const std::function<Sample(double)>& sample_at, double low, double high,
              const Sample& best) {
  Sample left = sample_at(high - kGoldenSection * (high - low));
  Sample right = sample_at(low + kGoldenSection * (high - low));
  while (high - low > kResolution) {
    if (left.error < right.error) {
      high = right.offset;
      right = left;
      left = sample_at(high - kGoldenSection * (high - low));
    } else {
      low = left.offset;
      left = right;
      right = sample_at(low + kGoldenSection * (high - low));
    }
  }
  return better(best, better(left, right));
}

/// The range, the error function and the coarse grid that the searches for all errors share.
struct Search {
  double low;   ///< s, least offset
  double high;  ///< s, greatest offset
  std::function<TrajectoryErrors(double offset)> errors_at;
  std::vector<std::pair<double, TrajectoryErrors>> coarse;  ///< (offset, errors) on the grid
};

Sample least(const Search& search, double (*error_of)(const TrajectoryErrors&)) {
  Sample best = {search.coarse.front().first, error_of(search.coarse.front().second)};
  for (const auto& [offset, errors] : search.coarse) {
    best = better(best, {offset, error_of(errors)});
  }
  const auto sample_at = [&](double offset) {
    return Sample{offset, error_of(search.errors_at(offset))};
  };
  return refine(sample_at, std::max(best.offset - kGridStep, search.low),
                std::min(best.offset + kGridStep, search.high), best);
}

}  // namespace

TimeOffset estimate_time_offset(const Trajectory& truth, const Trajectory& estimate,
                                const EvaluationOptions& options, double range) {
  options.validate();
  require(range > 0 && std::isfinite(range), "range: expected a positive number of seconds, got ",
          range);
  Search search = {options.time_offset - range, options.time_offset + range, {}, {}};
  const Trajectory inside = poses_inside(truth, estimate, search.low, search.high);
  EvaluationOptions no_offset = options;
  no_offset.time_offset = 0;
  search.errors_at = [&](double offset) {
    return evaluate(interpolate(truth, inside, offset), inside, no_offset);
  };
  for (const double offset : grid(options.time_offset, range)) {
    search.coarse.emplace_back(offset, search.errors_at(offset));
  }
  const Sample ate = least(search, [](const TrajectoryErrors& e) { return e.ate.rmse; });
  const Sample translation =
      least(search, [](const TrajectoryErrors& e) { return e.rpe.translation.rmse; });
  const Sample rotation =
      least(search, [](const TrajectoryErrors& e) { return e.rpe.rotation_deg.rmse; });
  return {.ate_offset = ate.offset,
          .ate_rmse = ate.error,
          .rpe_translation_offset = translation.offset,
          .rpe_translation_rmse = translation.error,
          .rpe_rotation_offset = rotation.offset,
          .rpe_rotation_rmse_deg = rotation.error};
}

}  // namespace vo
