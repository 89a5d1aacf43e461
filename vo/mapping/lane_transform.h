#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "vo/geometry/line_projection.h"
#include "vo/mapping/lane_image.h"
#include "vo/mapping/stereo_pair.h"

/// The geometry between the lines of two images for many edges at once.
namespace vo::detail {

/// The transforms from the camera of each edge's line in the host to that of the line that sees it
/// in the current image.
template <std::size_t kLanes>
struct LaneTransforms {
  std::array<Lanes<kLanes>, 9> R;  // row by row
  std::array<Lanes<kLanes>, 3> t;  // m
};

/// Sets the same transform for all edges.
template <std::size_t kLanes>
EDVO_INLINE void set_transform(const LineTransforms& lines, LaneTransforms<kLanes>& transforms) {
  for (std::size_t r = 0; r < 3; ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    for (std::size_t c = 0; c < 3; ++c) {
      transforms.R[3 * r + c].fill(lines.of_middle(row, static_cast<Eigen::Index>(c)));
    }
    transforms.t[r].fill(lines.of_middle(row, 3));
  }
}

/// Holds how far the lines that see each edge are past their image's middle line, as shares of the
/// image's height or width.
template <std::size_t kLanes>
struct LaneLines {
  Lanes<kLanes> host, current;
};

/// Finds the lines of edges at these rays in the host and these inverse depths, 1/m. The current
/// line is the one that would see the edge from the middle line's pose. Lens distortion is ignored.
template <std::size_t kLanes>
EDVO_INLINE void find_lines(const StereoPair& pair, const Lanes<kLanes>& ray_x,
                            const Lanes<kLanes>& ray_y, const Lanes<kLanes>& inverse_depth,
                            LaneLines<kLanes>& lines) {
  const LineProjection host(pair.host.camera, pair.lines.host_axis);
  const LineProjection current(pair.current.camera, pair.lines.current_axis);
  const Lanes<kLanes>& host_slope = pair.lines.host_axis == ReadoutAxis::rows ? ray_y : ray_x;
  const LineTransforms::Matrix34f& M = pair.lines.of_middle;
  const Eigen::Index across = pair.lines.current_axis == ReadoutAxis::rows ? 1 : 0;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = ray_x[i];
    const float y = ray_y[i];
    const float d = inverse_depth[i];
    const float p = M(across, 0) * x + M(across, 1) * y + M(across, 2) + d * M(across, 3);
    const float p_z = M(2, 0) * x + M(2, 1) * y + M(2, 2) + d * M(2, 3);
    const float past = current.past_middle(p / p_z);
    lines.host[i] = host.past_middle(host_slope[i]);
    lines.current[i] = p_z > 0 ? std::min(std::max(past, -0.5F), 0.5F) : 0;
  }
}

/// Sets each edge's transform, for edges at these rays in the host and these inverse depths, 1/m.
template <std::size_t kLanes>
EDVO_INLINE void set_transforms(const StereoPair& pair, const Lanes<kLanes>& ray_x,
                                const Lanes<kLanes>& ray_y, const Lanes<kLanes>& inverse_depth,
                                LaneTransforms<kLanes>& transforms) {
  if (!pair.lines.is_rolling) {
    set_transform(pair.lines, transforms);
    return;
  }
  LaneLines<kLanes> lines;
  find_lines(pair, ray_x, ray_y, inverse_depth, lines);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      const auto row = static_cast<Eigen::Index>(r);
      const auto column = static_cast<Eigen::Index>(c);
      const float middle = pair.lines.of_middle(row, column);
      const float by_host = pair.lines.by_host_line(row, column);
      const float by_current = pair.lines.by_current_line(row, column);
      const float by_both = pair.lines.by_both(row, column);
      Lanes<kLanes>& values = c < 3 ? transforms.R[3 * r + c] : transforms.t[r];
      for (std::size_t i = 0; i < kLanes; ++i) {
        values[i] = middle + lines.host[i] * by_host +
                    lines.current[i] * (by_current + lines.host[i] * by_both);
      }
    }
  }
}

}  // namespace vo::detail
