#pragma once

#include <string>

#include "vo/evaluation/evaluate.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// The two trajectories of an evaluation and what they are called.
struct EvaluatedTrajectories {
  const vo::Trajectory& truth;
  const vo::Trajectory& estimate;
  std::string truth_name;
  std::string estimate_name;
};

/// Returns the absolute error of positions, as `vo::evaluate` takes it, as the archive that
/// `evo_ape --save_results` writes and `evo_res` reads: info.json, stats.json, and the arrays
/// error_array, seconds_from_start, timestamps, distances_from_start (along the truth), distances
/// (along the aligned estimate) and, unless nothing is aligned, alignment_transformation_sim3, as
/// .npy of doubles. Throws vo::Error as `vo::evaluate` does.
std::string encode_evo_ape(const EvaluatedTrajectories& trajectories,
                           const vo::EvaluationOptions& options);

}  // namespace tools
