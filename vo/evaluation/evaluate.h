#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "vo/geometry/trajectory.h"

namespace vo {

/// Which transform is fitted between estimate and truth before the absolute error is taken.
enum class TrajectoryAlignment { none, se3, sim3 };

constexpr auto enum_names(TrajectoryAlignment) {
  return std::array{std::pair{TrajectoryAlignment::none, "none"},
                    std::pair{TrajectoryAlignment::se3, "se3"},
                    std::pair{TrajectoryAlignment::sim3, "sim3"}};
}

/// Over what the relative error is taken.
enum class IntervalUnit { seconds, frames };

struct RpeInterval {
  double length = 1;  ///< s, or a whole number of frames
  IntervalUnit unit = IntervalUnit::seconds;
};

struct EvaluationOptions {
  TrajectoryAlignment alignment = TrajectoryAlignment::se3;
  RpeInterval interval = {};
  double max_time_difference = 0.02;  ///< s, between associated poses
  double time_offset = 0;             ///< s, added to the estimate's stamps

  void validate() const;  ///< throws Error
};

struct Statistics {
  double rmse = 0;
  double mean = 0;
  double median = 0;
  double max = 0;
};

/// NaN without errors.
Statistics summarize(std::span<const double> errors);

struct RelativeErrors {
  Statistics translation;   ///< m per interval
  Statistics rotation_deg;  ///< deg per interval
  std::size_t pairs = 0;    ///< intervals compared; the statistics are NaN without any
};

/// With P the estimate, Q the truth and (i, j) an interval, the relative error is a rigid motion of
/// which the translation's norm and the rotation's angle are taken. Both definitions have the same
/// angle and differ in the translation.
struct TrajectoryErrors {
  Statistics ate;      ///< m, of positions after alignment (evaluate_ate.py, evo_ape)
  RelativeErrors rpe;  ///< E = P_i^-1 P_j (Q_i^-1 Q_j)^-1 as evaluate_rpe.py of the TUM benchmark
  RelativeErrors rpe_evo;       ///< E = (Q_i^-1 Q_j)^-1 P_i^-1 P_j as evo_rpe and the paper
  double scale = 1;             ///< of the estimate that fits the truth, 1 unless Sim(3) is fitted
  std::size_t matched = 0;      ///< poses of the estimate that have a partner in the truth
  double matched_fraction = 0;  ///< of the estimate's poses
};

/// Throws Error when fewer than three poses match.
TrajectoryErrors evaluate(const Trajectory& truth, const Trajectory& estimate,
                          const EvaluationOptions& options = {});

/// The estimate moved rigidly onto the truth, as for the absolute error. Throws as `evaluate`.
Trajectory align_trajectory(const Trajectory& truth, const Trajectory& estimate,
                            const EvaluationOptions& options = {});

/// The offset of the estimate's stamps, at most `range` from `options.time_offset`, that makes an
/// error least, as a diagnostic of the clocks: the figures at zero offset are the result. Truth is
/// interpolated, not associated, so the error is a smooth function of the offset. Only poses that
/// stay within the truth's time span are compared; throws Error when they are fewer than three.
struct TimeOffset {
  double ate_offset = 0;              ///< s, least ATE
  double ate_rmse = 0;                ///< m, there
  double rpe_translation_offset = 0;  ///< s, least RPE of the translation
  double rpe_translation_rmse = 0;    ///< m, there
  double rpe_rotation_offset = 0;     ///< s, least RPE of the rotation
  double rpe_rotation_rmse_deg = 0;   ///< deg, there
};

TimeOffset estimate_time_offset(const Trajectory& truth, const Trajectory& estimate,
                                const EvaluationOptions& options, double range = 0.1);

}  // namespace vo
