#include "vo/segmentation/tile_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vo/segmentation/static_evidence.h"
#include "vo/segmentation/tiles_where.h"

namespace vo {
namespace {

/// Returns each tile's mean of the values at the coarsest level's pixels that have depth, or 0
/// where none has.
ViewTiles::Values means_where_measured(const cv::Mat_<float>& values, const PyramidLevel& level) {
  const ViewTiles grid(level.camera);
  ViewTiles::Values sum{};
  ViewTiles::Values count{};
  for (int v = 0; v < level.depth.rows; ++v) {
    for (int u = 0; u < level.depth.cols; ++u) {
      if (has_depth(level.depth(v, u))) {
        const std::size_t tile = grid.of({u, v});
        sum[tile] += values(v, u);
        count[tile] += 1;
      }
    }
  }
  for (std::size_t tile = 0; tile < sum.size(); ++tile) {
    sum[tile] /= std::max(count[tile], 1.0F);
  }
  return sum;
}

using Histogram = std::array<double, 256>;

/// Returns the last bin of the lower group of Otsu's threshold, which has the greatest variance
/// between both groups.
std::size_t otsu_threshold(const Histogram& histogram) {
  double total = 0;
  double moment = 0;
  for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
    total += histogram[bin];
    moment += static_cast<double>(bin) * histogram[bin];
  }
  double below = 0;
  double moment_below = 0;
  double greatest = 0;
  std::size_t best = 0;
  for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
    below += histogram[bin];
    moment_below += static_cast<double>(bin) * histogram[bin];
    const double distance = moment_below * total - moment * below;
    const double between =
        below > 0 && below < total ? distance * distance / (below * (total - below)) : 0;
    if (between > greatest) {
      greatest = between;
      best = bin;
    }
  }
  return best;
}

/// Returns the bin of an inverse depth: 50 a 1/m, the last one from 5.1 / m on.
std::size_t inverse_depth_bin(float z) {
  return static_cast<std::size_t>(std::min(255.0F, 50 / z));
}

}  // namespace

ViewTiles::Values tile_depths(const FramePyramid& frame) {
  const PyramidLevel& level = frame.levels.back();
  return means_where_measured(level.depth, level);
}

bool is_same_depth(float a, float b) {
  constexpr float kSame = 0.08F;
  return std::abs(a - b) <= kSame * std::max(a, b);
}

TileMask far_tiles(const ViewTiles::Values& depths) {
  Histogram histogram{};
  for (const float z : depths) {
    if (has_depth(z)) {
      histogram[inverse_depth_bin(z)] += 1;
    }
  }
  const std::size_t split = otsu_threshold(histogram);
  return tiles_where([&](std::size_t tile) {
    return has_depth(depths[tile]) && inverse_depth_bin(depths[tile]) <= split;
  });
}

TileMask covered_tiles(const FramePyramid& frame, const ViewTiles::Values& depths) {
  constexpr float kBlack = 1.5F / 255;
  const PyramidLevel& level = frame.levels.back();
  const ViewTiles::Values intensity = means_where_measured(level.intensity, level);
  return tiles_where(
      [&](std::size_t tile) { return has_depth(depths[tile]) && intensity[tile] < kBlack; });
}

SurfaceAreas surface_areas(const ViewTiles::Values& log_odds, const ViewTiles::Values& depths,
                           const TileMask& tiles) {
  constexpr float kClearlyStatic = 0.5F;
  const TileMask moving = moving_tiles(log_odds);
  SurfaceAreas areas;
  for (std::size_t tile = 0; tile < depths.size(); ++tile) {
    const double area = tiles[tile] ? depths[tile] * depths[tile] : 0;
    areas.of_static += log_odds[tile] > kClearlyStatic ? area : 0;
    areas.of_moving += moving[tile] ? area : 0;
  }
  return areas;
}

}  // namespace vo
