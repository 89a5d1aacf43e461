#pragma once

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// Returns the relative error as evaluate_rpe.py --fixed_delta of the TUM benchmark takes it,
/// except that it never samples the pairs. An interval runs from each pose of the estimate to the
/// one nearest to its end, but not to the last one. Its poses are compared with the nearest ones of
/// the truth; it is left out when one of them is further away in time than twice the median
/// interval of the truth, which has at least two poses.
RelativeErrors relative_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

/// Returns the relative error as evo_rpe --all_pairs takes it. First each pose of the shorter
/// trajectory is associated with the nearest one of the other, then intervals are counted in
/// associated poses. Over seconds, which evo does not know, evaluate_rpe.py's intervals among them
/// are taken.
RelativeErrors relative_errors_evo(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

}  // namespace vo
