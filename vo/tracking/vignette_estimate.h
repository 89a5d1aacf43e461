#pragma once

#include <span>

#include "vo/alignment/joint_problem.h"
#include "vo/image/vignette.h"

namespace vo {

/// Estimates a lens's vignette while tracking: points grow darker as they move away from the
/// middle, whatever they show and however it was exposed. An ignored vignette biases every pose.
///
/// Every frame gives the normal equations of the vignette's coefficients at the points of one
/// keyframe, with the pose and the brightness of the pair eliminated; they are summed, starting
/// from a weak prior at no vignette. The estimate is shrunk to its significant part.
class VignetteEstimate {
 public:
  VignetteEstimate();

  const Vignette& vignette() const { return vignette_; }

  /// Adds an aligned frame by its last reference: the one with which it has least in common, where
  /// points moved farthest.
  void update(std::span<const AlignReference> references, const AlignCurrent& current,
              const SE3& T_cur_first, const AlignOptions& options);

 private:
  Eigen::Matrix2d information_;
  Eigen::Vector2d weighted_ = Eigen::Vector2d::Zero();  ///< information times the estimate
  Vignette vignette_;
  PointTerms scores_;  ///< point terms of the last frame
};

}  // namespace vo
