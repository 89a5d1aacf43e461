#pragma once

#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/tracking/tracking_result.h"

namespace tools {

/// Whether the covariances say how large the errors are: the normalized estimation error squared
/// (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and Navigation", 2001),
/// e^T C^-1 e of the error e = log(T_cur_ref T_cur_ref_true^-1) of each tracked frame. The median
/// over the frames, over that of chi^2 with six degrees of freedom: 1 is calibrated, above 1 the
/// covariances are too small. The median, because errors have heavier tails than a Gaussian and a
/// mean would be that of the few worst frames. NaN without a tracked frame of known truth.
double nees_median(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames);

}  // namespace tools
