#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/bootstrap/two_view.h"
#include "vo/geometry/se3.h"

namespace vo {

/// Fits the homography that takes the first rays of the pairs to the second, H ray = second up to
/// scale, robustly and from a rotation: what a camera sees of a plane, whatever its motion.
Eigen::Matrix3d fit_homography(const std::vector<RayPair>& pairs, const SE3& T_rotation);

/// Returns whether a plane explains the pairs as well as any depths do: Torr's geometric robust
/// information criterion (GRIC, IJCV 50, 2002), which weighs the residuals of a homography against
/// those of free depths and what each model is free to choose.
bool is_planar(const std::vector<RayPair>& pairs, const Eigen::Matrix3d& H, const TwoViewFit& free,
               double robust_scale);

/// Returns the motions that a homography may come from, their translations of unit length (Ma,
/// Soatto, Kosecka, Sastry, "An Invitation to 3-D Vision", algorithm 5.2). They are those that see
/// at least `min_in_front` of the pairs on a plane before both cameras: one, or two, which two
/// views of a plane cannot tell apart; none for a rotation.
std::vector<SE3> motions_of_plane(const std::vector<RayPair>& pairs, const Eigen::Matrix3d& H,
                                  double min_in_front);

}  // namespace vo
