#pragma once

#include <limits>
#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/tracking/tracking_result.h"

namespace tools {

/// The normalised estimation errors squared (NEES) e^T C^-1 e of poses with error e and covariance
/// C (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and Navigation", 2001)
/// over what chi^2 with six degrees of freedom has at the same percentile: 1 means calibrated,
/// above 1 that covariances are too small. Percentiles are nearest-rank; NaN without a tracked
/// frame of known truth.
struct Nees {
  double median = std::numeric_limits<double>::quiet_NaN();
  double p90 = std::numeric_limits<double>::quiet_NaN();  ///< of the tail, at the 90th percentile
};

/// Judges the alignments of tracked frames, e = log(T_cur_ref T_cur_ref_true^-1), by their
/// covariances.
Nees relative_nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames);

/// Judges the poses of tracked frames relative to the frame that their map began with, e =
/// log(T_cur_first T_cur_first_true^-1), by their absolute covariances.
Nees absolute_nees(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames);

/// Returns the greatest error of the position, m, of tracked frames, which excludes the uncertain
/// ones, relative to the frame that their map began with; NaN without a tracked frame of known
/// truth.
double greatest_sure_error(const vo::Trajectory& truth,
                           const std::vector<vo::TrackingResult>& frames);

}  // namespace tools
