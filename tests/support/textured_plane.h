#pragma once

#include <cmath>
#include <vector>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"

namespace support {

/// An endless plane through (0, 0, 2) in the world with a smooth-edged pattern, tilted so that
/// neither its depth nor its texture is symmetric. Depth and colour have closed forms.
struct TexturedPlane {
  Eigen::Vector3d normal = Eigen::Vector3d(0.25, -0.15, -1).normalized();
  Eigen::Vector3d point{0, 0, 2};  ///< m

  /// Planar depth of the plane at a pixel, m; 0 where the ray misses.
  double depth(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera,
               const Eigen::Vector2d& pixel) const {
    const Eigen::Vector3d ray = T_world_camera.rotation() * camera.unproject(pixel, 1);
    const double z = normal.dot(point - T_world_camera.translation()) / normal.dot(ray);
    return z > 0 ? z : 0;
  }

  /// 0..1; edges about a centimetre wide, every 12 to 30 cm, none of them parallel to another set.
  static double texture(const Eigen::Vector3d& p_world) {
    const double x = p_world.x();
    const double y = p_world.y();
    const double waves = std::sin(21 * x + 5 * y) * std::sin(17 * y - 4 * x) +
                         0.5 * std::sin(9 * x + 1) + 0.5 * std::sin(11 * y + 7 * x + 2);
    return 0.5 + 0.35 * std::tanh(6 * waves);
  }

  vo::RgbdFrame render(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera,
                       double timestamp = 0) const {
    return render_lines(
        camera, vo::ReadoutAxis::rows, [&](int) { return T_world_camera; }, timestamp);
  }

  /// Renders each line, a row or a column, from a pose of its own, T_world_line(line): a rolling
  /// shutter.
  template <typename PoseOfLine>
  vo::RgbdFrame render_lines(const vo::PinholeCamera& camera, vo::ReadoutAxis axis,
                             PoseOfLine T_world_line, double timestamp = 0) const {
    const bool by_row = axis == vo::ReadoutAxis::rows;
    std::vector<vo::SE3> T_world_lines;
    for (int line = 0; line < (by_row ? camera.height : camera.width); ++line) {
      T_world_lines.push_back(T_world_line(line));
    }
    vo::ByteImage image(camera.height, camera.width);
    vo::DepthImage depths(camera.height, camera.width);
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        const vo::SE3& T_world_camera = T_world_lines[static_cast<std::size_t>(by_row ? v : u)];
        const double z = depth(camera, T_world_camera, {u, v});
        const double value =
            z > 0 ? texture(T_world_camera * camera.unproject(Eigen::Vector2d(u, v), z)) : 0;
        depths(v, u) = static_cast<float>(z);
        image(v, u) = static_cast<uchar>(std::lround(255 * value));
      }
    }
    return {timestamp, image, depths};
  }
};

inline vo::PinholeCamera small_camera() {
  return vo::PinholeCamera::from_horizontal_fov(320, 240, 60);
}

}  // namespace support
