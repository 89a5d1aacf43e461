#pragma once

#include <cstddef>
#include <vector>

#include "tests/support/textured_plane.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"

namespace support {

/// The textured plane as the small camera sees it there: one level, with edges.
inline vo::FramePyramid plane_view(const vo::SE3& T_world_camera) {
  vo::FramePyramid pyramid = vo::build_pyramid(
      TexturedPlane().render(small_camera(), T_world_camera), small_camera(), {.levels = 1});
  vo::add_edges(pyramid, vo::EdgeOptions{});
  return pyramid;
}

/// Every `step`-th point, of those farther than the border (px) from the small camera's.
inline vo::EdgePointLevel interior(const vo::EdgePointLevel& points, int border,
                                   std::size_t step = 1) {
  const vo::PinholeCamera camera = small_camera();
  vo::EdgePointLevel kept = points;
  kept.keep_if([&](std::size_t i) {
    const cv::Point pixel = points.pixel[i];
    return i % step == 0 && pixel.x > border && pixel.x < camera.width - border &&
           pixel.y > border && pixel.y < camera.height - border;
  });
  return kept;
}

}  // namespace support
