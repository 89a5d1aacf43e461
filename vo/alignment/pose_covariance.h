#pragma once

#include "vo/alignment/joint_problem.h"
#include "vo/alignment/noise_curvature.h"

namespace vo {

/// Returns the covariance of the left increment of T_cur_first that comes from what differs from
/// cell to cell of the image, at the pose where the system was linearized:
///
///   C = f H^-1 (sum over cells of g_c g_c^T) H^-1 / a^2
///
/// - H is the system's without the noise's part, see NoiseFreeCurvature.
/// - g_c is the part of b that comes from one cell of the current image: the cluster-robust
///   'sandwich' (Huber 1967; White 1980; Cameron & Miller, "A Practitioner's Guide to
///   Cluster-Robust Inference", 2015). It takes the residuals at their own size and allows any
///   correlation within a cell, whereas s^2 H^-1 would take all pixels as independent.
/// - a is the mean curvature of the robust loss over the mean weight: H is made of weights and
///   overstates the curvature (Huber, "Robust Regression", 1973).
/// - f = max(1, chi^2 / degrees of freedom) of the references' disagreement, each judged by its own
///   cells (Birge, "The Calculation of Errors by the Method of Least Squares", 1932), covers errors
///   of keyframes' poses, depths and shutters, which no cell of one image shows.
Matrix6d sandwich_covariance(const JointProblem& problem, const JointSystem& system,
                             const SE3& T_cur_first);

/// Returns the sandwich_covariance() plus three terms for errors that it does not show:
///
/// - 0.005 px of interpolation bias that all pixels share, as if H held one pixel's information
///   only; it was found on rendered sequences with perfect depth, where it brings NEES to 0.5
///   to 1.5.
/// - With a rolling shutter, what the pose would move by if the velocities that lines are moved
///   with were off by their doubt, for each frame independently and in any direction, to first
///   order.
/// - With a rolling shutter, the acceleration a while an image is taken, which a steady velocity
///   leaves out. At t from the middle it displaces the camera by a t^2 / 2; its mean over lines
///   read in T and exposed for E, a (T^2 + E^2) / 24, is taken for the pose. T is the read-out
///   time, E is not known and taken as 0.7 T; a is the last known one, in any direction.
///
/// Errors that all references share are not included: depth that lags behind the image, a read-out
/// time that is not found yet. `scores` and `curvature` must be those of `system`.
Matrix6d pose_covariance(const JointProblem& problem, const JointSystem& system,
                         const JointScores& scores, const NoiseFreeCurvature& curvature,
                         const SE3& T_cur_first);

}  // namespace vo
