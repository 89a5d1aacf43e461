#include "vo/segmentation/motion_segmentation.h"

#include <algorithm>

#include "vo/segmentation/tile_surfaces.h"

namespace vo {

TileEvidence MotionSegmentation::expected(const ViewTiles::Values& depths) const {
  constexpr float kMemory = 0.85F;  // share of the log-odds that is left after a frame
  TileEvidence result;
  for (std::size_t tile = 0; tile < result.size(); ++tile) {
    result[tile] =
        kMemory * (is_same_depth(depths_[tile], depths[tile]) ? log_odds_[tile]
                                                              : mean_around(tile, depths[tile]));
  }
  return result;
}

/// Returns the mean log-odds of the tile's neighbours that showed this depth, or 0 without any.
float MotionSegmentation::mean_around(std::size_t tile, float depth) const {
  float sum = 0;
  float count = 0;
  ViewTiles::for_each_around(tile, [&](std::size_t near) {
    if (is_same_depth(depths_[near], depth)) {
      sum += log_odds_[near];
      count += 1;
    }
  });
  return sum / std::max(count, 1.0F);
}

void MotionSegmentation::update(const ViewTiles::Values& depths, const TileEvidence& log_odds) {
  log_odds_ = log_odds;
  depths_ = depths;
  moving_ = moving_tiles(log_odds);
}

TileEvidence log_odds_after(const TileEvidence& expected, const TileEvidence& evidence) {
  constexpr float kMostMoving = -4;
  constexpr float kMostStatic = 1;
  TileEvidence result;
  for (std::size_t tile = 0; tile < result.size(); ++tile) {
    const float now = std::clamp(evidence[tile], -kMostEvidenceOfFrame, kMostEvidenceOfFrame);
    result[tile] = std::clamp(expected[tile] + now, kMostMoving, kMostStatic);
  }
  return result;
}

TileEvidence log_odds_after_change(const TileEvidence& expected, const TileEvidence& before,
                                   const TileEvidence& now) {
  TileEvidence moving = expected;
  TileEvidence evidence = now;
  for (std::size_t tile = 0; tile < evidence.size(); ++tile) {
    moving[tile] = std::min(moving[tile], 0.0F);
    if (now[tile] < 0) {
      evidence[tile] -= std::clamp(before[tile], 0.0F, kMostEvidenceOfFrame);
    }
  }
  return log_odds_after(moving, evidence);
}

}  // namespace vo
