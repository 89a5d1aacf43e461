#pragma once

#include <optional>
#include <string>

#include "tools/bench/frames.h"
#include "tools/bench/race.h"

namespace tools {

/// Errors against the ground truth, to be read beside the run time.
struct Accuracy {
  double rpe_translation_rmse_m = 0;  ///< RPE over 1 s; NaN where the frames span less
  double rpe_rotation_rmse_deg = 0;   ///< RPE over 1 s
  double ate_rmse_m = 0;
};

/// Summary of one peer, a row of the table. Times exclude the warm-up frames.
struct Summary {
  std::string name;
  double median_ms = 0;
  double p90_ms = 0;
  double cpu_ms = 0;  ///< median processor time; speed-ups are ratios of it
  StageCosts stages;  ///< median of each stage; they need not add up to median_ms
  double points = 0;  ///< median number of aligned points
  std::size_t keyframes = 0;
  double tracked_fraction = 0;
  std::optional<double> map_mib;     ///< memory of the map after the last frame, MiB
  std::optional<Accuracy> accuracy;  ///< empty without enough ground truth
};

Summary summarize(const RaceResult& result, const Frames& input, const RaceOptions& options);

}  // namespace tools
