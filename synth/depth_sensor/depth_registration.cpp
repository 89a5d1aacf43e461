#include "synth/depth_sensor/depth_registration.h"

#include <algorithm>
#include <cmath>

namespace synth {
namespace {

/// Returns the colour pixel that a corner of a depth pixel projects to.
Eigen::Vector2i landing(const vo::PinholeCamera& depth_camera, const vo::PinholeCamera& color,
                        const Eigen::Vector2d& corner, double depth,
                        const Eigen::Vector3d& offset) {
  const Eigen::Vector2d pixel = color.project(depth_camera.unproject(corner, depth) + offset);
  return {static_cast<int>(std::lround(std::clamp(pixel.x(), -10.0, color.width + 10.0))),
          static_cast<int>(std::lround(std::clamp(pixel.y(), -10.0, color.height + 10.0)))};
}

void cover(const Eigen::Vector2i& first, const Eigen::Vector2i& last, float depth,
           vo::DepthImage& result) {
  for (int v = std::max(first.y(), 0); v <= std::min(last.y(), result.rows - 1); ++v) {
    for (int u = std::max(first.x(), 0); u <= std::min(last.x(), result.cols - 1); ++u) {
      float& there = result(v, u);
      there = vo::has_depth(there) ? std::min(there, depth) : depth;
    }
  }
}

}  // namespace

vo::DepthImage registered(const vo::DepthImage& depth, const vo::PinholeCamera& color,
                          const Eigen::Vector3d& offset) {
  constexpr double kCorner = 0.499;  // px, below 0.5: a corner stays in its own pixel
  const vo::PinholeCamera depth_camera = color.without_distortion();
  vo::DepthImage result(color.height, color.width, 0.0F);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const float value = depth(v, u);
      if (!vo::has_depth(value) || value + offset.z() <= 0) {
        continue;
      }
      const Eigen::Vector2d centre(u, v);
      const Eigen::Vector2d corner(kCorner, kCorner);
      cover(landing(depth_camera, color, centre - corner, value, offset),
            landing(depth_camera, color, centre + corner, value, offset),
            static_cast<float>(value + offset.z()), result);
    }
  }
  return result;
}

}  // namespace synth
