#include "vo/segmentation/free_space.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "vo/residuals/view_places.h"

namespace vo {
namespace {

constexpr float kThrough = 0.92F;  // share of the depth measured there

/// Returns whether a depth is clearly nearer than the nine depths measured around a pixel; on the
/// border, and where one of them is missing, that is not known.
bool is_seen_through(float z, const DepthImage& depth, int u, int v) {
  if (!(z < kThrough * depth(v, u)) || u < 1 || v < 1 || u + 1 >= depth.cols ||
      v + 1 >= depth.rows) {
    return false;
  }
  float nearest = depth(v, u);
  for (int row = v - 1; row <= v + 1; ++row) {
    for (int column = u - 1; column <= u + 1; ++column) {
      nearest = std::min(nearest, depth(row, column));
    }
  }
  return has_depth(nearest) && z < kThrough * nearest;
}

/// The points that some neighbouring pixels of a row of depths show, m.
struct RowPoints {
  std::array<float, ViewPlaces::kMost> x, y;

  RowPoints(const float* z, const cv::Vec2f* rays, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = z[i] * rays[i][0];
      y[i] = z[i] * rays[i][1];
    }
  }
};

/// Pixels side by side of a row, and where their points are in another view.
struct PlacedPixels {
  int first, v;    // px, the first of them
  const float* z;  // m, depths
  std::size_t count;
  const ViewPlaces& places;
};

void add_seen_through(const PlacedPixels& pixels, const DepthImage& other, const ViewTiles& grid,
                      float evidence, ViewTiles::Values& sum) {
  const ViewPlaces& places = pixels.places;
  for (std::size_t i = 0; i < pixels.count; ++i) {
    if (has_depth(pixels.z[i]) && places.is_in_view(i) &&
        is_seen_through(places.z[i], other, cvRound(places.u[i]), cvRound(places.v[i]))) {
      sum[grid.of({pixels.first + static_cast<int>(i), pixels.v})] += evidence;
    }
  }
}

}  // namespace

void add_seen_through(const PyramidLevel& own, const PyramidLevel& other, const SE3& T_other_own,
                      float evidence, ViewTiles::Values& sum) {
  const ViewPlacer placer(other.camera, T_other_own);
  const ViewTiles grid(own.camera);
  const auto cols = static_cast<std::size_t>(own.depth.cols);
  ViewPlaces places;
  for (int v = 0; v < own.depth.rows; ++v) {
    for (std::size_t first = 0; first < cols; first += ViewPlaces::kMost) {
      const std::size_t count = std::min(ViewPlaces::kMost, cols - first);
      const float* z = own.depth[v] + first;
      const RowPoints row(z, own.rays[v] + first, count);
      placer.place({row.x.data(), row.y.data(), z, count}, places);
      add_seen_through({static_cast<int>(first), v, z, count, places}, other.depth, grid, evidence,
                       sum);
    }
  }
}

}  // namespace vo
