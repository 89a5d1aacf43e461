#pragma once

#include <cstddef>

#include "vo/image/view_grid.h"
#include "vo/segmentation/static_evidence.h"
#include "vo/segmentation/tile_mask.h"

namespace vo {

/// Follows from frame to frame which tiles of the view are static and which move by themselves. A
/// tile keeps its log-odds while it shows the same depth; where the depth changes, those of the
/// neighbours of the new depth move in, so that the label goes along with what moves.
class MotionSegmentation {
 public:
  /// Returns the log-odds that the tiles of a frame of these tile_depths(), m, are static, from the
  /// frames before.
  TileEvidence expected(const ViewTiles::Values& depths) const;

  /// Takes in the tile_depths(), m, and the log-odds of a frame's tiles.
  void update(const ViewTiles::Values& depths, const TileEvidence& log_odds);

  /// Forgets all, where the camera is lost and no tile is known any more.
  void reset() { *this = {}; }

  /// Returns the tiles that move in the last frame.
  const TileMask& moving() const { return moving_; }

  /// Returns the share of the view's tiles that move.
  double moving_fraction() const { return share_of_view(moving_); }

 private:
  float mean_around(std::size_t tile, float depth) const;

  TileEvidence log_odds_{};
  ViewTiles::Values depths_{};  ///< tile_depths() of the last frame
  TileMask moving_;
};

/// Returns the log-odds of tiles after a frame's evidence, of which none counts for everything.
TileEvidence log_odds_after(const TileEvidence& expected, const TileEvidence& evidence);

/// Returns the log-odds of tiles after a frame in which another motion than before was found to be
/// the camera's; `before` and `now` are the frame's evidence with either motion. That a tile agreed
/// with the motion before no longer says that it is static. One that disagrees with the motion now
/// moves along with the other one, as far as it agrees with that.
TileEvidence log_odds_after_change(const TileEvidence& expected, const TileEvidence& before,
                                   const TileEvidence& now);

}  // namespace vo
