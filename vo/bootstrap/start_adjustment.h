#pragma once

#include <cstddef>
#include <vector>

#include "vo/bootstrap/two_view.h"
#include "vo/geometry/se3.h"

namespace vo {

/// What a frame sees of places that the first frame sees, too.
struct StartView {
  SE3 T_frame_first;
  std::vector<RayPair> pairs;
  std::vector<std::size_t> places;  ///< of each pair
};

/// The start of a map: places by their inverse depths in the first frame, and other frames that see
/// them.
struct StartViews {
  std::vector<StartView> views;
  std::vector<double> inverse_depth;  ///< of each place
};

/// Bundle adjustment (Triggs, McLauchlan, Hartley, Fitzgibbon 2000): poses and inverse depths
/// together, Levenberg and Marquardt's steps with the depths eliminated place by place (Schur
/// complement), Cauchy's loss. The length of the last view's translation is held: it is the scale.
/// The first frame is where the places are defined, without an error of its own.
void adjust(StartViews& start, double robust_scale);

}  // namespace vo
