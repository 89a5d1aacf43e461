#include "vo/segmentation/tile_mask.h"

#include <algorithm>

#include "vo/residuals/warp.h"

namespace vo {
namespace {

/// Says of a reference's points whether they are seen in tiles of a level of the current view.
class SeenTest {
 public:
  SeenTest(const SeenTiles& seen, std::size_t level)
      : tiles_(seen.tiles),
        camera_(seen.current.levels[level].camera),
        grid_(camera_),
        warp_(camera_, seen.T_cur_ref) {}

  bool holds(const Eigen::Vector3f& p_ref) const {
    const WarpedPoint<float> point = warp_point<float>(warp_, p_ref);
    return is_in_view(point, camera_) && tiles_[grid_.of(point.u, point.v)];
  }

 private:
  const TileMask& tiles_;
  const PinholeCamera& camera_;
  ViewTiles grid_;
  Warp<float> warp_;
};

}  // namespace

TileMask grown(const TileMask& tiles) {
  TileMask result;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    if (tiles[tile]) {
      ViewTiles::for_each_around(tile, [&](std::size_t near) { result.set(near); });
    }
  }
  return result;
}

TileMask tiles_with_points(const FramePyramid& frame, const EdgePoints& points) {
  const ViewTiles grid(frame.levels.front().camera);
  TileMask once;
  TileMask twice;
  for (const cv::Point& pixel : points.levels.front().pixel) {
    const std::size_t tile = grid.of(pixel);
    twice[tile] = once[tile];
    once.set(tile);
  }
  return twice;
}

double share_in(const TileMask& tiles, const FramePyramid& frame, const EdgePoints& points) {
  if (tiles.none()) {
    return 0;
  }
  const ViewTiles grid(frame.levels.front().camera);
  const std::vector<cv::Point>& pixels = points.levels.front().pixel;
  const auto count = std::count_if(pixels.begin(), pixels.end(),
                                   [&](const cv::Point& pixel) { return tiles[grid.of(pixel)]; });
  return pixels.empty() ? 0 : static_cast<double>(count) / static_cast<double>(pixels.size());
}

void leave_out(const TileMask& tiles, const FramePyramid& frame, EdgePoints& points) {
  for (std::size_t l = 0; l < points.levels.size(); ++l) {
    const ViewTiles grid(frame.levels[l].camera);
    EdgePointLevel& level = points.levels[l];
    level.keep_if([&](std::size_t i) { return !tiles[grid.of(level.pixel[i])]; });
  }
}

void leave_out(const TileMask& tiles, const FramePyramid& frame, SurfacePoints& surface) {
  leave_out({tiles, frame, SE3()}, surface);
}

void leave_out(const SeenTiles& seen, EdgePoints& points) {
  for (std::size_t l = 0; l < points.levels.size(); ++l) {
    const SeenTest test(seen, l);
    EdgePointLevel& level = points.levels[l];
    level.keep_if([&](std::size_t i) {
      return !test.holds({level.x_ref[i], level.y_ref[i], level.z_ref[i]});
    });
  }
}

void leave_out(const SeenTiles& seen, SurfacePoints& surface) {
  const SeenTest test(seen, 0);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (!test.holds(surface.position[i])) {
      surface.position[kept] = surface.position[i];
      surface.normal[kept] = surface.normal[i];
      ++kept;
    }
  }
  surface.position.resize(kept);
  surface.normal.resize(kept);
}

}  // namespace vo
