#pragma once

#include <optional>
#include <string>

#include "tools/bench/frames.h"
#include "tools/bench/race.h"

namespace tools {

/// Errors against the ground truth, so that a speed is never read without what it bought.
struct Accuracy {
  double rpe_translation_rmse_m = 0;  ///< over 1 s; NaN where the frames span less
  double rpe_rotation_rmse_deg = 0;   ///< over 1 s
  double ate_rmse_m = 0;
};

/// One row of the table. Times are of the frames after the warm-up.
struct Summary {
  std::string name;
  double median_ms = 0;
  double p90_ms = 0;
  double cpu_ms = 0;  ///< median: what the ratios are of
  StageCosts stages;  ///< medians, stage by stage: they need not add up to the frame's
  double points = 0;  ///< median
  std::size_t keyframes = 0;
  double tracked_fraction = 0;
  std::optional<double> map_mib;     ///< after the last frame
  std::optional<Accuracy> accuracy;  ///< nothing without enough ground truth
};

Summary summarize(const RaceResult& result, const Frames& input, const RaceOptions& options);

}  // namespace tools
