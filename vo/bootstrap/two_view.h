#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/geometry/se3.h"

namespace vo {

/// One place seen in two frames, as rays (X / Z, Y / Z).
struct RayPair {
  Eigen::Vector2d first{0, 0};
  Eigen::Vector2d second{0, 0};
};

/// The rotation that explains the pairs best without any translation, and the median distance that
/// it leaves: the parallax.
struct RotationFit {
  SE3 T_second_first;
  double parallax = 0;  ///< in units of rays; times the focal length, px
};

RotationFit fit_rotation(const std::vector<RayPair>& pairs);

/// Motion and structure at once.
struct TwoViewFit {
  SE3 T_second_first;                 ///< translation of unit length
  std::vector<double> inverse_depth;  ///< of each pair in the first frame
  double residual = 0;                ///< median distance of projection and ray
  double in_front = 0;                ///< share of pairs with positive inverse depth
};

/// Gauss-Newton over pose and inverse depths together, the depths eliminated point by point (Schur
/// complement), robust, from 26 directions of translation and the rotation given; the best of them.
TwoViewFit fit_two_views(const std::vector<RayPair>& pairs, const SE3& T_rotation,
                         double robust_scale);

/// The inverse depth of a pair under a motion, by least squares along the epipolar line.
double triangulate(const RayPair& pair, const SE3& T_second_first);

/// The pose that agrees best with places of known inverse depth, robust, from a guess.
SE3 fit_pose(const std::vector<RayPair>& pairs, const std::vector<double>& inverse_depth,
             const SE3& T_second_first_guess, double robust_scale);

}  // namespace vo
