#include "vo/alignment/surface_normal.h"

#include <cmath>

namespace vo {
namespace {

constexpr int kReach = 2;  // px to either side

/// The slopes of the inverse depth along an axis, over the inverse depth at the centre.
struct RelativeSlopes {
  float before, behind;

  float mean() const { return (before + behind) / 2; }
  float deviation() const { return std::abs(before - behind) / 2; }
};

bool has_depth_around(const DepthImage& depth, const cv::Point& pixel) {
  const cv::Rect inside(kReach, kReach, depth.cols - 2 * kReach, depth.rows - 2 * kReach);
  return inside.contains(pixel) && depth(pixel) > 0 && depth(pixel.y, pixel.x - kReach) > 0 &&
         depth(pixel.y, pixel.x + kReach) > 0 && depth(pixel.y - kReach, pixel.x) > 0 &&
         depth(pixel.y + kReach, pixel.x) > 0;
}

RelativeSlopes slopes_along(const PyramidLevel& level, const cv::Point& centre,
                            const cv::Point& step, int axis) {
  const auto slope_to = [&](const cv::Point& side) {
    return (level.depth(centre) / level.depth(side) - 1) /
           (level.rays(side)[axis] - level.rays(centre)[axis]);
  };
  return {slope_to(centre - step), slope_to(centre + step)};
}

}  // namespace

std::optional<SurfaceNormal> surface_normal(const PyramidLevel& level, const cv::Point& pixel) {
  if (!has_depth_around(level.depth, pixel)) {
    return {};
  }
  const RelativeSlopes by_x = slopes_along(level, pixel, {kReach, 0}, 0);
  const RelativeSlopes by_y = slopes_along(level, pixel, {0, kReach}, 1);
  const float rest = 1 - level.rays(pixel)[0] * by_x.mean() - level.rays(pixel)[1] * by_y.mean();
  return SurfaceNormal{{by_x.mean(), by_y.mean(), rest}, {by_x.deviation(), by_y.deviation()}};
}

}  // namespace vo
