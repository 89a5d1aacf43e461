#include "synth/depth_sensor/depth_registration.h"

#include <algorithm>
#include <cmath>

namespace synth {
namespace {

/// Footprint bounds the colour pixels that a depth pixel covers, both ends included.
struct Footprint {
  Eigen::Vector2i first;
  Eigen::Vector2i last;
};

/// The colour camera as it stands to the depth camera.
class ColorView {
 public:
  ColorView(const vo::PinholeCamera& color, const vo::SE3& T_color_depth)
      : color_(color),
        depth_camera_(color.without_distortion()),
        R_color_depth_(T_color_depth.rotation_matrix()),
        offset_(T_color_depth.translation()) {}

  /// Returns what is `depth`, m, before the depth camera's pixel, in the colour camera's axes.
  Eigen::Vector3d point(const Eigen::Vector2d& pixel, double depth) const {
    return R_color_depth_ * depth_camera_.unproject(pixel, depth) + offset_;
  }

  /// Returns the colour pixels between those that a depth pixel's corners project to: two opposite
  /// ones, as librealsense has it, where the cameras have the same axes, and otherwise all four.
  Footprint footprint(const Eigen::Vector2d& centre, double depth) const {
    constexpr double kCorner = 0.499;  // px, below 0.5: a corner stays in its own pixel
    const auto pixel_of = [&](double right, double down) {
      return landing(centre + kCorner * Eigen::Vector2d(right, down), depth);
    };
    const Eigen::Vector2i first = pixel_of(-1, -1);
    const Eigen::Vector2i last = pixel_of(1, 1);
    Footprint result{first.cwiseMin(last), first.cwiseMax(last)};
    if (!R_color_depth_.isIdentity(0)) {
      for (const Eigen::Vector2i& pixel : {pixel_of(1, -1), pixel_of(-1, 1)}) {
        result = {result.first.cwiseMin(pixel), result.last.cwiseMax(pixel)};
      }
    }
    return result;
  }

 private:
  Eigen::Vector2i landing(const Eigen::Vector2d& corner, double depth) const {
    const Eigen::Vector2d pixel = color_.project(point(corner, depth));
    return {static_cast<int>(std::lround(std::clamp(pixel.x(), -10.0, color_.width + 10.0))),
            static_cast<int>(std::lround(std::clamp(pixel.y(), -10.0, color_.height + 10.0)))};
  }

  const vo::PinholeCamera& color_;
  vo::PinholeCamera depth_camera_;
  Eigen::Matrix3d R_color_depth_;
  Eigen::Vector3d offset_;
};

void cover(const Footprint& footprint, float depth, vo::DepthImage& result) {
  const auto& [first, last] = footprint;
  for (int v = std::max(first.y(), 0); v <= std::min(last.y(), result.rows - 1); ++v) {
    for (int u = std::max(first.x(), 0); u <= std::min(last.x(), result.cols - 1); ++u) {
      float& there = result(v, u);
      there = vo::has_depth(there) ? std::min(there, depth) : depth;
    }
  }
}

}  // namespace

vo::DepthImage registered(const vo::DepthImage& depth, const vo::PinholeCamera& color,
                          const vo::SE3& T_color_depth) {
  const ColorView view(color, T_color_depth);
  vo::DepthImage result(color.height, color.width, 0.0F);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const float value = depth(v, u);
      const Eigen::Vector2d centre(u, v);
      const double color_depth = vo::has_depth(value) ? view.point(centre, value).z() : 0;
      if (color_depth > 0) {
        cover(view.footprint(centre, value), static_cast<float>(color_depth), result);
      }
    }
  }
  return result;
}

}  // namespace synth
