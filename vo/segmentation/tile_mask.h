#pragma once

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/image/view_grid.h"
#include "vo/residuals/surface_points.h"

namespace vo {

/// A set of a view's tiles.
using TileMask = ViewTiles::Set;

/// Returns the share of the view that these tiles are.
inline double share_of_view(const TileMask& tiles) {
  return static_cast<double>(tiles.count()) / ViewTiles::kCount;
}

/// Returns the tiles and their neighbours.
TileMask grown(const TileMask& tiles);

/// Returns the tiles of a frame's view that at least two of its finest points lie in.
TileMask tiles_with_points(const FramePyramid& frame, const EdgePoints& points);

/// Returns the share of a frame's finest points that lie in these tiles.
double share_in(const TileMask& tiles, const FramePyramid& frame, const EdgePoints& points);

/// Removes the points that lie in these tiles of their own frame's view.
void leave_out(const TileMask& tiles, const FramePyramid& frame, EdgePoints& points);

/// Removes the surface points that lie in these tiles of their own frame's view.
void leave_out(const TileMask& tiles, const FramePyramid& frame, SurfacePoints& surface);

/// Tiles of the current view, and the pose in it of a reference whose points are looked up there.
struct SeenTiles {
  const TileMask& tiles;
  const FramePyramid& current;
  SE3 T_cur_ref;
};

/// Removes a reference's points that are seen in the tiles.
void leave_out(const SeenTiles& seen, EdgePoints& points);

/// Removes a reference's surface points that are seen in the tiles.
void leave_out(const SeenTiles& seen, SurfacePoints& surface);

}  // namespace vo
