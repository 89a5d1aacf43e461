#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/geometry/se3.h"

namespace vo {

/// One place seen in two frames, as rays (X/Z, Y/Z), and how far from the image's middle each is
/// seen: to the right and down, as shares of the image's width and height.
struct RayPair {
  Eigen::Vector2d first{0, 0};
  Eigen::Vector2d second{0, 0};
  Eigen::Vector2d first_from_middle{0, 0};
  Eigen::Vector2d second_from_middle{0, 0};
};

/// The rotation that explains the pairs best without any translation, and the median distance that
/// it leaves: the parallax.
struct RotationFit {
  SE3 T_second_first;
  double parallax = 0;  ///< in ray coordinates; times the focal length it is in px
};

RotationFit fit_rotation(const std::vector<RayPair>& pairs);

/// The motion between two frames and the structure, fitted together.
struct TwoViewFit {
  SE3 T_second_first;                 ///< its translation has unit length
  std::vector<double> inverse_depth;  ///< of each pair in the first frame
  double residual = 0;                ///< median distance of projection and ray
  double in_front = 0;                ///< share of pairs with positive inverse depth
};

/// Fits pose and inverse depths together by robust Gauss-Newton, the depths eliminated point by
/// point (Schur complement), from the rotation and each of 26 directions of translation; returns
/// the best fit.
TwoViewFit fit_two_views(const std::vector<RayPair>& pairs, const SE3& T_rotation,
                         double robust_scale);

/// Fits pose and inverse depths together in the same way, from one guess of the pose.
TwoViewFit refine_two_views(const std::vector<RayPair>& pairs, const SE3& T_guess,
                            double robust_scale);

/// Returns a pair's inverse depth under a motion, by least squares along the epipolar line.
double triangulate(const RayPair& pair, const SE3& T_second_first);

/// Fits the pose to places of known inverse depth, robustly, from a guess.
SE3 fit_pose(const std::vector<RayPair>& pairs, const std::vector<double>& inverse_depth,
             const SE3& T_second_first_guess, double robust_scale);

}  // namespace vo
