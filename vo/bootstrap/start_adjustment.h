#pragma once

#include <cstddef>
#include <vector>

#include "vo/bootstrap/two_view.h"
#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"

namespace vo {

/// The places of the first frame that another frame sees, and that frame's pose.
struct StartView {
  SE3 T_frame_first;
  std::vector<RayPair> pairs;
  std::vector<std::size_t> places;    ///< index of each pair's place
  std::vector<Eigen::Vector2d> bend;  ///< 1/s, what a read-out time moves each pair's second ray by

  /// Returns what the pair's rays would be with a global shutter.
  RayPair unbent(std::size_t pair, double readout_s) const;
};

/// The start of a map: places by their inverse depths in the first frame, and the views of other
/// frames that see them.
struct StartViews {
  std::vector<StartView> views;
  std::vector<double> inverse_depth;  ///< of each place, in the scale of the poses
  Readout readout;                    ///< rolling shutter's read-out
  bool readout_is_known = false;      ///< whether its time is held; its axis always is
};

/// Adjusts poses and inverse depths together by bundle adjustment (Triggs, McLauchlan, Hartley,
/// Fitzgibbon 2000): Levenberg-Marquardt steps with the depths eliminated place by place (Schur
/// complement) and Cauchy's loss. The length of the last view's translation is fixed, as it is the
/// scale. The first frame defines the places, without an error of its own. The read-out time is
/// adjusted with them, to first order, unless it is known.
void adjust(StartViews& start, double robust_scale);

/// Returns what `adjust` minimises.
double loss_of(const StartViews& start, double robust_scale);

}  // namespace vo
