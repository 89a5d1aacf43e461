#pragma once

#include "vo/geometry/depth_noise.h"
#include "vo/image/view_grid.h"
#include "vo/residuals/depth_term.h"
#include "vo/segmentation/static_evidence.h"

namespace vo {

/// What speaks for a motion's being that of the camera: the log-likelihood of what a view shows
/// where each part of it is static or moves by itself, whichever is more likely, over that where
/// all moves. A part counts by the area of its surface, in the unit of SurfaceAreas: things that
/// move are smaller than the world. What moves counts nothing, as it may do so in any way.
struct MotionSupport {
  double by_intensities = 0;
  double by_surfaces = 0;  ///< by their distances from the surfaces of a reference

  double total() const { return by_intensities + by_surfaces; }
};

/// Sums the evidence that speaks for a view's tiles being static; their tile_depths() are `depths`,
/// m.
double intensity_support(const TileEvidence& evidence, const ViewTiles::Values& depths);

/// Sums the evidence that speaks for surface points being static: of their distances from the
/// surface that is measured where they are seen, a t-distribution of the depth camera's noise, at
/// least 0.2 % of the depth, stands against one of 4 % of the depth. Points that see another
/// surface say nothing.
double surface_support(const DepthView& view, const DepthNoise& noise);

/// Returns whether a motion is clearly better supported than another: by 3 % by intensities, or by
/// 10 % by both together. Depth errs alike over whole surfaces and must speak the more clearly. On
/// fr1/xyz, where nothing moves, the motion of the far surfaces is supported by 2 % more than that
/// of all points at most by intensities, and by 6 % more by both in one frame of twenty.
bool is_clearly_better(const MotionSupport& support, const MotionSupport& other);

}  // namespace vo
