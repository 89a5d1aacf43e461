#pragma once

#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/tracking/tracking_result.h"

namespace tools {

/// Returns the normalised estimation error squared (NEES) of the tracked poses (Bar-Shalom, Li,
/// Kirubarajan, "Estimation with Applications to Tracking and Navigation", 2001): the median of e^T
/// C^-1 e over the frames, e = log(T_cur_ref T_cur_ref_true^-1), divided by the median of chi^2
/// with six degrees of freedom. 1 means calibrated, above 1 that the covariances are too small. It
/// is the median because errors have heavier tails than a Gaussian and a few frames would dominate
/// a mean. NaN without a tracked frame of known truth.
double nees_median(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames);

}  // namespace tools
