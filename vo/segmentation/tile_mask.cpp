#include "vo/segmentation/tile_mask.h"

#include <algorithm>
#include <array>

#include "vo/residuals/view_places.h"

namespace vo {
namespace {

/// Says of a reference's points whether they are seen in tiles of a level of the current view.
class SeenTest {
 public:
  SeenTest(const SeenTiles& seen, std::size_t level)
      : tiles_(seen.tiles),
        grid_(seen.current.levels[level].camera),
        placer_(seen.current.levels[level].camera, seen.T_cur_ref) {}

  /// Looks for at most ViewPlaces::kMost points.
  void look_for(const PointArrays& points) { placer_.place(points, places_); }

  /// Returns whether the i-th of the points that were looked for is seen in the tiles.
  bool holds(std::size_t i) const {
    return places_.is_in_view(i) && tiles_[grid_.of(places_.u[i], places_.v[i])];
  }

 private:
  const TileMask& tiles_;
  ViewTiles grid_;
  ViewPlacer placer_;
  ViewPlaces places_;
};

/// Coordinates of surface points, m.
struct SurfaceArrays {
  std::array<float, ViewPlaces::kMost> x, y, z;
  std::size_t count = 0;

  SurfaceArrays(const SurfacePoints& surface, std::size_t first)
      : count(std::min(ViewPlaces::kMost, surface.size() - first)) {
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = surface.position[first + i].x();
      y[i] = surface.position[first + i].y();
      z[i] = surface.position[first + i].z();
    }
  }
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
    SeenTest test(seen, l);
    EdgePointLevel& level = points.levels[l];
    level.keep_if([&](std::size_t i) {
      const std::size_t of_block = i % ViewPlaces::kMost;
      if (of_block == 0) {
        test.look_for({level.x_ref.data() + i, level.y_ref.data() + i, level.z_ref.data() + i,
                       std::min(ViewPlaces::kMost, level.size() - i)});
      }
      return !test.holds(of_block);
    });
  }
}

void leave_out(const SeenTiles& seen, SurfacePoints& surface) {
  SeenTest test(seen, 0);
  std::size_t kept = 0;
  for (std::size_t first = 0; first < surface.size(); first += ViewPlaces::kMost) {
    const SurfaceArrays some(surface, first);
    test.look_for({some.x.data(), some.y.data(), some.z.data(), some.count});
    for (std::size_t i = 0; i < some.count; ++i) {
      if (!test.holds(i)) {
        surface.position[kept] = surface.position[first + i];
        surface.normal[kept] = surface.normal[first + i];
        ++kept;
      }
    }
  }
  surface.position.resize(kept);
  surface.normal.resize(kept);
}

}  // namespace vo
