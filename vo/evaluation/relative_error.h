#pragma once

#include <vector>

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// The errors of motions over intervals, one element for each in all three.
struct IntervalErrors {
  std::vector<double> timestamps;     ///< s, stamp of the estimate's pose where the interval begins
  std::vector<double> translations;   ///< m
  std::vector<double> rotations_deg;  ///< deg
};

/// Returns the relative error as evaluate_rpe.py --fixed_delta of the TUM benchmark takes it,
/// except that it never samples the pairs. An interval runs from each pose of the estimate to the
/// one nearest to its end, but not to the last one. Its poses are compared with the nearest ones of
/// the truth; it is left out when one of them is further away in time than twice the median
/// interval of the truth, which has at least two poses.
IntervalErrors interval_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

/// Returns the statistics of interval_errors_tum().
RelativeErrors relative_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

/// Returns the relative error as evo_rpe --all_pairs takes it. First each pose of the shorter
/// trajectory is associated with the nearest one of the other, then intervals are counted in
/// associated poses. Over seconds, which evo does not know, evaluate_rpe.py's intervals among them
/// are taken.
RelativeErrors relative_errors_evo(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

}  // namespace vo
