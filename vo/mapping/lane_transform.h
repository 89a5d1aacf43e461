#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "vo/geometry/row_motion.h"
#include "vo/mapping/lane_image.h"
#include "vo/mapping/stereo_pair.h"

/// The geometry between the rows of two images for many edges at once.
namespace vo::detail {

/// The transforms from the camera of each edge's row in the host to that of the row that sees it in
/// the current image.
template <std::size_t kLanes>
struct LaneTransforms {
  std::array<Lanes<kLanes>, 9> R;  // row by row
  std::array<Lanes<kLanes>, 3> t;  // m
};

/// Sets the same transform for all edges.
template <std::size_t kLanes>
EDVO_INLINE void set_transform(const RowTransforms& rows, LaneTransforms<kLanes>& transforms) {
  for (std::size_t r = 0; r < 3; ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    for (std::size_t c = 0; c < 3; ++c) {
      transforms.R[3 * r + c].fill(rows.of_middle(row, static_cast<Eigen::Index>(c)));
    }
    transforms.t[r].fill(rows.of_middle(row, 3));
  }
}

/// How far the rows that see each edge are below their image's middle row, in image heights.
template <std::size_t kLanes>
struct LaneRows {
  Lanes<kLanes> host, current;
};

/// Finds the rows of edges at these rays in the host and these inverse depths, 1/m. The current row
/// is the one that would see the edge from the middle row's pose. Lens distortion is ignored.
template <std::size_t kLanes>
EDVO_INLINE void find_rows(const StereoPair& pair, const Lanes<kLanes>& ray_x,
                           const Lanes<kLanes>& ray_y, const Lanes<kLanes>& inverse_depth,
                           LaneRows<kLanes>& rows) {
  const PinholeCamera& host = pair.host.camera;
  const PinholeCamera& current = pair.current.camera;
  const auto host_fy = static_cast<float>(host.fy);
  const auto host_cy = static_cast<float>(host.cy);
  const auto current_fy = static_cast<float>(current.fy);
  const auto current_cy = static_cast<float>(current.cy);
  const float inverse_host_height = 1 / static_cast<float>(host.height);
  const float inverse_current_height = 1 / static_cast<float>(current.height);
  const RowTransforms::Matrix34f& M = pair.rows.of_middle;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = ray_x[i];
    const float y = ray_y[i];
    const float d = inverse_depth[i];
    const float p_y = M(1, 0) * x + M(1, 1) * y + M(1, 2) + d * M(1, 3);
    const float p_z = M(2, 0) * x + M(2, 1) * y + M(2, 2) + d * M(2, 3);
    const float below = below_middle(current_fy * (p_y / p_z) + current_cy, inverse_current_height);
    rows.host[i] = below_middle(host_fy * y + host_cy, inverse_host_height);
    rows.current[i] = p_z > 0 ? std::min(std::max(below, -0.5F), 0.5F) : 0;
  }
}

/// Sets each edge's transform, for edges at these rays in the host and these inverse depths, 1/m.
template <std::size_t kLanes>
EDVO_INLINE void set_transforms(const StereoPair& pair, const Lanes<kLanes>& ray_x,
                                const Lanes<kLanes>& ray_y, const Lanes<kLanes>& inverse_depth,
                                LaneTransforms<kLanes>& transforms) {
  if (!pair.rows.is_rolling) {
    set_transform(pair.rows, transforms);
    return;
  }
  LaneRows<kLanes> rows;
  find_rows(pair, ray_x, ray_y, inverse_depth, rows);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      const auto row = static_cast<Eigen::Index>(r);
      const auto column = static_cast<Eigen::Index>(c);
      const float middle = pair.rows.of_middle(row, column);
      const float by_host = pair.rows.by_host_row(row, column);
      const float by_current = pair.rows.by_current_row(row, column);
      const float by_both = pair.rows.by_both(row, column);
      Lanes<kLanes>& values = c < 3 ? transforms.R[3 * r + c] : transforms.t[r];
      for (std::size_t i = 0; i < kLanes; ++i) {
        values[i] = middle + rows.host[i] * by_host +
                    rows.current[i] * (by_current + rows.host[i] * by_both);
      }
    }
  }
}

}  // namespace vo::detail
