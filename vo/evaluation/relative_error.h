#pragma once

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// The relative error as evaluate_rpe.py --fixed_delta of the TUM benchmark takes it, except that
/// it never samples the pairs. An interval runs from each pose of the estimate to the one nearest
/// to its end, but not to the last one. Its poses are compared with the nearest ones of the truth;
/// it is left out when one of them is further away than twice the median interval of the truth,
/// which has at least two poses.
RelativeErrors relative_errors_tum(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

/// The relative error as evo_rpe --all_pairs takes it. First each pose of the shorter trajectory is
/// associated with the nearest one of the other, then intervals are counted in associated poses.
/// Over seconds, which evo does not know, they are chosen as above among the associated poses.
RelativeErrors relative_errors_evo(const Trajectory& truth, const Trajectory& estimate,
                                   const EvaluationOptions& options);

}  // namespace vo
