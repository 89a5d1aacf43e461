#pragma once

#include "vo/image/pyramid.h"
#include "vo/image/view_grid.h"
#include "vo/segmentation/tile_mask.h"

namespace vo {

/// Returns the mean depth measured in each tile, m, or 0 where none is.
ViewTiles::Values tile_depths(const FramePyramid& frame);

/// Returns whether two depths may be of one surface: they differ by at most 8 %.
bool is_same_depth(float a, float b);

/// Returns the tiles of the farther surfaces by their tile_depths(), m. Near and far are told apart
/// by the threshold of the inverse depths that makes both groups most alike in themselves (Otsu, "A
/// threshold selection method from gray-level histograms", 1979).
TileMask far_tiles(const ViewTiles::Values& depths);

/// Returns the tiles, whose tile_depths() are `depths`, that are black, below 1.5 grey levels in
/// the mean, though depth is measured in them: something covers the view of the image sensor and
/// not that of the depth sensor.
TileMask covered_tiles(const FramePyramid& frame, const ViewTiles::Values& depths);

/// The areas of the surfaces that a view shows, m^2 but for a factor that all views of a camera
/// have in common: a tile counts by its squared depth.
struct SurfaceAreas {
  double of_static = 0;  ///< of the tiles that are clearly static
  double of_moving = 0;  ///< of the tiles that clearly move by themselves

  /// Returns the moving area over the static one, at most 1.
  double moving_ratio() const {
    return of_moving < of_static ? of_moving / of_static : of_moving > 0 ? 1 : 0;
  }
};

/// Sums the areas of those of some tiles that have these tile_depths(), m, by the log-odds that
/// they are static.
SurfaceAreas surface_areas(const ViewTiles::Values& log_odds, const ViewTiles::Values& depths,
                           const TileMask& tiles);

}  // namespace vo
