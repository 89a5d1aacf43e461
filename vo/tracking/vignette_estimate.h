#pragma once

#include <span>

#include "vo/alignment/joint_problem.h"
#include "vo/image/vignette.h"

namespace vo {

/// A lens's vignette, found while tracking: points grow darker as they move away from the middle,
/// whatever they show and however it was exposed. Taken for a change of the scene it pulls at every
/// pose.
///
/// Every frame gives the normal equations of the vignette's coefficients at the points of one
/// keyframe, with the pose and the brightness of the pair eliminated; they are summed, starting
/// from none that is held weakly. What is found is taken out as far as it is significant.
class VignetteEstimate {
 public:
  VignetteEstimate();

  const Vignette& vignette() const { return vignette_; }

  /// Takes in an aligned frame by its last reference: that which it has least in common with,
  /// where points moved farthest.
  void update(std::span<const AlignReference> references, const AlignCurrent& current,
              const SE3& T_cur_first, const AlignOptions& options);

 private:
  Eigen::Matrix2d information_;
  Eigen::Vector2d weighted_ = Eigen::Vector2d::Zero();  ///< information times the best coefficients
  Vignette vignette_;
  PointTerms scores_;  ///< of the last frame
};

}  // namespace vo
