#pragma once

#include <vector>

#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/surface_points.h"

namespace vo {

/// Surface points of one frame and the depth image of another that they are compared with.
struct DepthView {
  const SurfacePoints& surface;
  const PyramidLevel& image;
  SE3 T_cur_ref;  ///< ref: the points' frame, cur: the image's
};

/// Normal equations H delta = -b of exp(delta) T_cur_ref of the point-to-plane distances (Chen &
/// Medioni, "Object modelling by registration of multiple range images", IVC 1992), each point
/// compared with the depth measured at the pixel where it is seen.
struct DepthSystem {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  double cost = 0;  ///< robust, summed; unseen points cost as much as one at the scale
};

/// With the loss of a t-distribution of standard deviation `scale`, m.
DepthSystem linearize_depth(const DepthView& view, double scale);

/// What a point adds to the system's b, and where it is seen.
struct DepthScore {
  Eigen::Vector2d pixel;
  Vector6d b;
};

std::vector<DepthScore> score_depth(const DepthView& view, double scale);

/// 1.4826 median |r| of the distances, m; 0 where no point is seen.
double distance_spread(const DepthView& view);

/// Share of the points in view, of those where any depth is measured, for which it is the point's
/// to 5 %; 1 where hardly any is measured.
double depth_agreement(const DepthView& view);

}  // namespace vo
