#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// Sums of w s J J^T over the points of a pair of images, where s is how far past the middle line a
/// point is seen, as a share of the image's height or width. With a rolling shutter a velocity
/// moves a point by s times itself over the read-out time, so these sums are how b changes with
/// velocities.
struct RollingShutterMoments {
  using Moment = Eigen::Matrix<double, kPassParameters, 6>;

  Moment points = Moment::Zero();  ///< sum with s at the points' own pixels
  Moment image = Moment::Zero();   ///< sum with s at the pixels where they are looked up

  /// Sums the moments of a view's points; `scores` must have been computed from that view.
  static RollingShutterMoments of(const PointView& view, const PointTerms& scores,
                                  ReadoutAxis axis);
};

/// Sums that tell how the residuals of a pair of images change with a read-out time t along the
/// rows and along the columns: each point has q = dr / dt, one element for either axis.
struct ReadoutMoments {
  using Coupling = Eigen::Matrix<double, kPassParameters, 2>;

  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();       ///< sum of w q q^T
  Eigen::Vector2d by_residual = Eigen::Vector2d::Zero();  ///< sum of w r q
  Coupling coupling = Coupling::Zero();                   ///< sum of w J q^T

  /// Sums the moments. `points_twist` and `image_twist` are the velocities while either frame was
  /// read, m/s and rad/s, in the camera frame of the image.
  static ReadoutMoments of(const PointView& view, const PointTerms& scores,
                           const Vector6d& points_twist, const Vector6d& image_twist);
};

}  // namespace vo
