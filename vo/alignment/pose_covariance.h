#pragma once

#include "vo/alignment/joint_problem.h"

namespace vo {

/// Covariance of the left increment of T_cur_first that comes from what differs from cell to cell
/// of the image, at the pose where the system was linearized:
///
///   C = f H^-1 (sum over cells of g_c g_c^T) H^-1 / a^2
///
/// - g_c is the part of b that comes from one cell of the current image: the cluster-robust
///   'sandwich' (Huber 1967; White 1980; Cameron & Miller, "A Practitioner's Guide to
///   Cluster-Robust Inference", 2015). Residuals speak for themselves, at any scale, and those of
///   one cell may be as alike as they like. s^2 H^-1 takes all pixels as independent.
/// - a, the mean curvature of the robust loss over the mean weight: H is made of weights and
///   overstates the curvature (Huber, "Robust Regression", 1973).
/// - f = max(1, chi^2 / degrees of freedom) of the references' disagreement, each judged by its own
///   cells (Birge, "The Calculation of Errors by the Method of Least Squares", 1932): errors of
///   keyframes' poses, depths and shutters, which no cell of one image shows.
Matrix6d sandwich_covariance(const JointProblem& problem, const JointSystem& system,
                             const SE3& T_cur_first);

/// The same, and 0.005 px of interpolation bias that all pixels share: as if H knew of one pixel
/// only. Found on rendered sequences with perfect depth, where it brings NEES to 0.5 to 1.5.
///
/// With a rolling shutter also what the pose would move by if the velocities that rows are moved
/// with were off by their doubt, of each frame by itself and in any direction: to first order, from
/// how b changes with each velocity.
///
/// What all references share is in none of them: depth that lags behind the image, a read-out time
/// that is not found yet. `scores` are the system's.
Matrix6d pose_covariance(const JointProblem& problem, const JointSystem& system,
                         const JointScores& scores, const SE3& T_cur_first);

}  // namespace vo
