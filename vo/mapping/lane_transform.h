#pragma once

#include <array>
#include <cstddef>

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

/// Sets each edge's transform. The current row is the one that would see the edge, at this ray in
/// the host and this inverse depth, 1/m, from the middle row's pose. Lens distortion is ignored in
/// finding the rows.
template <std::size_t kLanes>
EDVO_INLINE void set_transforms(const StereoPair& pair, const Lanes<kLanes>& ray_x,
                                const Lanes<kLanes>& ray_y, const Lanes<kLanes>& inverse_depth,
                                LaneTransforms<kLanes>& transforms) {
  const RowTransforms& rows = pair.rows;
  if (!rows.is_rolling) {
    set_transform(rows, transforms);
    return;
  }
  const Projection<float> host(pair.host.camera);
  const Projection<float> current(pair.current.camera);
  const float host_height = 1 / static_cast<float>(pair.host.camera.height);
  const float current_height = 1 / static_cast<float>(pair.current.camera.height);
  const RowTransforms::Matrix34f& M = rows.of_middle;
  Lanes<kLanes> host_row;
  Lanes<kLanes> current_row;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = ray_x[i];
    const float y = ray_y[i];
    const float d = inverse_depth[i];
    const float p_y = M(1, 0) * x + M(1, 1) * y + M(1, 2) + d * M(1, 3);
    const float p_z = M(2, 0) * x + M(2, 1) * y + M(2, 2) + d * M(2, 3);
    host_row[i] = below_middle(host.fy * y + host.cy, host_height);
    const float below = below_middle(current.fy * (p_y / p_z) + current.cy, current_height);
    current_row[i] = p_z > 0 ? std::min(std::max(below, -0.5F), 0.5F) : 0;
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      const auto row = static_cast<Eigen::Index>(r);
      const auto column = static_cast<Eigen::Index>(c);
      const float middle = M(row, column);
      const float by_host = rows.by_host_row(row, column);
      const float by_current = rows.by_current_row(row, column);
      const float by_both = rows.by_both(row, column);
      Lanes<kLanes>& values = c < 3 ? transforms.R[3 * r + c] : transforms.t[r];
      for (std::size_t i = 0; i < kLanes; ++i) {
        values[i] =
            middle + host_row[i] * by_host + current_row[i] * (by_current + host_row[i] * by_both);
      }
    }
  }
}

}  // namespace vo::detail
