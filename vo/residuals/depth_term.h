#pragma once

#include <vector>

#include "vo/core/normal_equations.h"
#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/surface_points.h"

namespace vo {

/// Surface points of one frame and the depth image of another that they are compared with.
struct DepthView {
  const SurfacePoints& surface;
  const PyramidLevel& image;
  SE3 T_cur_ref;  ///< ref: the points' frame, cur: the image's frame
};

/// Linearizes point-to-plane distances (Chen & Medioni, "Object modelling by registration of
/// multiple range images", IVC 1992), m, in the left increment of T_cur_ref. Each point is compared
/// with the depth measured at the pixel where it is seen. The robust loss is that of a
/// t-distribution of standard deviation `scale`, m; an unseen point costs as much as the scale.
NormalEquations<6> linearize_depth(const DepthView& view, double scale);

/// A point's term of b and the pixel where it is seen.
struct DepthScore {
  Eigen::Vector2d pixel;
  Vector6d b;
};

/// Lists the terms of the points that are seen; `scores` are overwritten.
void score_depth(const DepthView& view, double scale, std::vector<DepthScore>& scores);

/// Returns 1.4826 times the median |r| of the distances, m, or 0 where no point is seen. Of many
/// points it takes some 600, evenly spread.
double distance_spread(const DepthView& view);

/// A surface point's depth and its distance from the surface that is measured where it is seen, m.
struct SurfaceDistance {
  float depth;
  float distance;
};

/// Lists the distances of the points that are seen; `distances` are overwritten.
void surface_distances(const DepthView& view, std::vector<SurfaceDistance>& distances);

/// Returns the share of the points seen at a pixel of measured depth whose own depth agrees with it
/// to 5 %, or 1 if there are fewer than 20 such points.
double depth_agreement(const DepthView& view);

}  // namespace vo
