#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "vo/geometry/trajectory.h"

namespace vo {

/// The transform that is fitted between estimate and truth before the absolute error is taken.
enum class TrajectoryAlignment { none, se3, sim3 };

constexpr auto enum_names(TrajectoryAlignment) {
  return std::array{std::pair{TrajectoryAlignment::none, "none"},
                    std::pair{TrajectoryAlignment::se3, "se3"},
                    std::pair{TrajectoryAlignment::sim3, "sim3"}};
}

/// The unit of the intervals over which the relative error is taken.
enum class IntervalUnit { seconds, frames };

struct RpeInterval {
  double length = 1;  ///< s, or a whole number of frames
  IntervalUnit unit = IntervalUnit::seconds;
};

struct EvaluationOptions {
  TrajectoryAlignment alignment = TrajectoryAlignment::se3;
  RpeInterval interval = {};
  double max_time_difference = 0.02;  ///< s, greatest between associated poses
  double time_offset = 0;             ///< s, added to the estimate's stamps

  void validate() const;  ///< throws Error unless the values are usable
};

struct Statistics {
  double rmse = 0;
  double mean = 0;
  double median = 0;
  double max = 0;
};

/// Returns the statistics of the errors, NaN if there are none.
Statistics summarize(std::span<const double> errors);

struct RelativeErrors {
  Statistics translation;   ///< m per interval
  Statistics rotation_deg;  ///< deg per interval
  std::size_t pairs = 0;    ///< intervals compared; the statistics are NaN without any
};

/// Errors of an estimate P against the truth Q. For an interval (i, j) the relative error E is a
/// rigid motion of which the translation's norm and the rotation's angle are taken. Both
/// definitions have the same angle and differ in the translation.
struct TrajectoryErrors {
  Statistics ate;      ///< m, of positions after alignment (evaluate_ate.py, evo_ape)
  RelativeErrors rpe;  ///< E = P_i^-1 P_j (Q_i^-1 Q_j)^-1 as evaluate_rpe.py of the TUM benchmark
  RelativeErrors rpe_evo;   ///< E = (Q_i^-1 Q_j)^-1 P_i^-1 P_j as evo_rpe and the benchmark's paper
  double scale = 1;         ///< factor from estimate to truth, 1 unless Sim(3) is fitted
  std::size_t matched = 0;  ///< poses of the estimate that have a partner in the truth
  double matched_fraction = 0;  ///< `matched` as a share of the estimate's poses
};

/// Returns the absolute and relative errors of an estimate. Throws Error when the options are
/// invalid or fewer than three poses match.
TrajectoryErrors evaluate(const Trajectory& truth, const Trajectory& estimate,
                          const EvaluationOptions& options = {});

/// The errors of which TrajectoryErrors has the statistics: `ate` of each matched pose, `rpe` of
/// each interval.
struct ErrorsOverTime {
  std::vector<double> timestamps;        ///< s, of the estimate's matched poses
  std::vector<double> ate;               ///< m
  std::vector<double> rpe_timestamps;    ///< s, of the poses where the intervals begin
  std::vector<double> rpe_translation;   ///< m
  std::vector<double> rpe_rotation_deg;  ///< deg
};

/// Returns the errors as `evaluate` takes them, and throws as it does.
ErrorsOverTime errors_over_time(const Trajectory& truth, const Trajectory& estimate,
                                const EvaluationOptions& options = {});

/// Returns the share of a sequence's frames, given by their stamps in s, that the estimate has a
/// pose for: one within 0.1 ms, more than rounding and less than a frame.
double tracked_fraction(std::span<const double> frames, const Trajectory& estimate);

/// Returns the estimate moved onto the truth as it is before the absolute error is taken: by the
/// rigid motion or the similarity of least squares over the matched positions, or not at all. There
/// is no result when fewer than three poses match.
std::optional<Trajectory> align_trajectory(const Trajectory& truth, const Trajectory& estimate,
                                           const EvaluationOptions& options = {});

/// Offsets of the estimate's stamps that make an error least, as a diagnostic of the clocks: the
/// figures at zero offset remain the result.
struct TimeOffset {
  double ate_offset = 0;              ///< s, offset of the least ATE
  double ate_rmse = 0;                ///< m, ATE at `ate_offset`
  double rpe_translation_offset = 0;  ///< s, offset of the least RPE of the translation
  double rpe_translation_rmse = 0;    ///< m, RPE at `rpe_translation_offset`
  double rpe_rotation_offset = 0;     ///< s, offset of the least RPE of the rotation
  double rpe_rotation_rmse_deg = 0;   ///< deg, RPE at `rpe_rotation_offset`
};

/// Returns the offsets, at most `range` from `options.time_offset`, with the least errors. Truth is
/// interpolated, not associated, so an error is a smooth function of the offset. Only poses that
/// stay within the truth's time span at every offset are compared; throws Error when they are fewer
/// than three.
TimeOffset estimate_time_offset(const Trajectory& truth, const Trajectory& estimate,
                                const EvaluationOptions& options, double range = 0.1);

}  // namespace vo
