#include "vo/evaluation/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/evaluation/relative_error.h"
#include "vo/evaluation/umeyama.h"
#include "vo/geometry/associate.h"

namespace vo {
namespace {

constexpr std::size_t kMinMatches = 3;  // fewer points do not determine a rotation

using Matches = std::vector<std::pair<std::size_t, std::size_t>>;

std::string describe_span(const std::vector<double>& timestamps) {
  return timestamps.empty() ? "has no poses"
                            : concat("spans ", format_real(timestamps.front()), " s to ",
                                     format_real(timestamps.back()), " s");
}

/// Returns pairs (index in the truth, index in the estimate) of associated poses.
Matches associated(const Trajectory& truth, const Trajectory& estimate,
                   const EvaluationOptions& options) {
  return associate(timestamps_of(truth), timestamps_of(estimate, options.time_offset),
                   options.max_time_difference);
}

/// Returns the pairs of associated poses. Throws Error when they are fewer than three.
Matches match(const Trajectory& truth, const Trajectory& estimate,
              const EvaluationOptions& options) {
  Matches matches = associated(truth, estimate, options);
  require(matches.size() >= kMinMatches, "cannot evaluate: ", matches.size(), " of ",
          estimate.size(), " poses of the estimate are within ", options.max_time_difference,
          " s of a pose of the truth, expected at least ", kMinMatches, "; the truth ",
          describe_span(timestamps_of(truth)), ", the estimate with an offset of ",
          format_real(options.time_offset), " s ",
          describe_span(timestamps_of(estimate, options.time_offset)));
  return matches;
}

struct Positions {
  std::vector<Eigen::Vector3d> truth;
  std::vector<Eigen::Vector3d> estimate;
};

Positions matched_positions(const Trajectory& truth, const Trajectory& estimate,
                            const Matches& matches) {
  Positions positions;
  for (const auto& [truth_index, estimate_index] : matches) {
    positions.truth.push_back(truth[truth_index].T_world_camera.translation());
    positions.estimate.push_back(estimate[estimate_index].T_world_camera.translation());
  }
  return positions;
}

Similarity fit(const Positions& positions, TrajectoryAlignment alignment) {
  switch (alignment) {
    case TrajectoryAlignment::se3:
      return fit_rigid(positions.estimate, positions.truth);
    case TrajectoryAlignment::sim3:
      return fit_similarity(positions.estimate, positions.truth);
    case TrajectoryAlignment::none:
      break;
  }
  return {};
}

std::vector<double> absolute_errors(const Positions& positions, const Similarity& alignment) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < positions.truth.size(); ++i) {
    errors.push_back((alignment * positions.estimate[i] - positions.truth[i]).norm());
  }
  return errors;
}

Trajectory scaled(Trajectory trajectory, double scale) {
  for (auto& [timestamp, T_world_camera] : trajectory) {
    T_world_camera = {T_world_camera.rotation(), scale * T_world_camera.translation()};
  }
  return trajectory;
}

}  // namespace

void EvaluationOptions::validate() const {
  require(interval.length > 0 && std::isfinite(interval.length),
          "interval.length: expected a positive number, got ", interval.length);
  require(interval.unit != IntervalUnit::frames || interval.length == std::floor(interval.length),
          "interval.length: expected a whole number of frames, got ", interval.length);
  require(max_time_difference >= 0 && std::isfinite(max_time_difference),
          "max_time_difference: expected at least 0 s, got ", max_time_difference);
  require(std::isfinite(time_offset), "time_offset: expected a number of seconds, got ",
          time_offset);
}

Statistics summarize(std::span<const double> errors) {
  if (errors.empty()) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, kUnknown, kUnknown};
  }
  double sum = 0;
  double sum_of_squares = 0;
  for (const double error : errors) {
    sum += error;
    sum_of_squares += error * error;
  }
  std::vector<double> sorted(errors.begin(), errors.end());
  std::sort(sorted.begin(), sorted.end());
  const auto count = static_cast<double>(sorted.size());
  return {.rmse = std::sqrt(sum_of_squares / count),
          .mean = sum / count,
          .median = (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2,
          .max = sorted.back()};
}

TrajectoryErrors evaluate(const Trajectory& truth, const Trajectory& estimate,
                          const EvaluationOptions& options) {
  options.validate();
  const Matches matches = match(truth, estimate, options);
  TrajectoryErrors errors;
  {
    const Positions positions = matched_positions(truth, estimate, matches);
    const Similarity alignment = fit(positions, options.alignment);
    errors.ate = summarize(absolute_errors(positions, alignment));
    errors.scale = alignment.scale;
  }
  const bool is_scaled = errors.scale != 1;
  const Trajectory scaled_estimate = is_scaled ? scaled(estimate, errors.scale) : Trajectory();
  const Trajectory& compared = is_scaled ? scaled_estimate : estimate;
  errors.rpe = relative_errors_tum(truth, compared, options);
  errors.rpe_evo = relative_errors_evo(truth, compared, options);
  errors.matched = matches.size();
  errors.matched_fraction =
      static_cast<double>(matches.size()) / static_cast<double>(estimate.size());
  return errors;
}

ErrorsOverTime errors_over_time(const Trajectory& truth, const Trajectory& estimate,
                                const EvaluationOptions& options) {
  options.validate();
  const Matches matches = match(truth, estimate, options);
  const Positions positions = matched_positions(truth, estimate, matches);
  const Similarity alignment = fit(positions, options.alignment);
  IntervalErrors relative = interval_errors_tum(truth, scaled(estimate, alignment.scale), options);
  ErrorsOverTime errors{.timestamps = {},
                        .ate = absolute_errors(positions, alignment),
                        .rpe_timestamps = std::move(relative.timestamps),
                        .rpe_translation = std::move(relative.translations),
                        .rpe_rotation_deg = std::move(relative.rotations_deg)};
  for (const auto& [truth_index, estimate_index] : matches) {
    errors.timestamps.push_back(estimate[estimate_index].timestamp);
  }
  return errors;
}

double tracked_fraction(std::span<const double> frames, const Trajectory& estimate) {
  constexpr double kSameStamp = 1e-4;  // s
  return static_cast<double>(associate(frames, timestamps_of(estimate), kSameStamp).size()) /
         static_cast<double>(frames.size());
}

std::optional<Trajectory> align_trajectory(const Trajectory& truth, const Trajectory& estimate,
                                           const EvaluationOptions& options) {
  const Matches matches = associated(truth, estimate, options);
  if (matches.size() < kMinMatches) {
    return std::nullopt;
  }
  const Similarity fitted = fit(matched_positions(truth, estimate, matches), options.alignment);
  const Eigen::Quaterniond rotation(fitted.rotation);
  Trajectory aligned = estimate;
  for (auto& [timestamp, T_world_camera] : aligned) {
    T_world_camera = {rotation * T_world_camera.rotation(), fitted * T_world_camera.translation()};
  }
  return aligned;
}

}  // namespace vo
