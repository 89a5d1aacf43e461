#pragma once

#include <vector>

#include <Eigen/Core>

#include "vo/core/se3.h"
#include "vo/image/edge_points.h"
#include "vo/tracking/point_pass.h"

namespace vo {

/// Sums over the points of a pair of images of w s J J^T, where s is how far below the middle row a
/// point is seen, in image heights. With a rolling shutter a velocity moves a point by s times
/// itself over the read-out time, so these are how b changes with velocities.
struct RowMoments {
  using Moment = Eigen::Matrix<double, kPassParameters, 6>;

  Moment points = Moment::Zero();  ///< s where the points are
  Moment image = Moment::Zero();   ///< s where they are looked up

  /// `scores` are of the view.
  static RowMoments of(const PointView& view, const PointScores& scores);
};

}  // namespace vo
