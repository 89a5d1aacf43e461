#include "vo/segmentation/free_space.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "vo/core/instruction_set.h"
#include "vo/residuals/point_block.h"

namespace vo {
namespace {

using detail::BlockRow;
using detail::kBlock;
using detail::PassWarp;

constexpr float kThrough = 0.92F;  // share of the depth measured there

/// Some neighbouring pixels of a row of depths, and where another frame sees them. Pixels without
/// depth, or out of view, are at (0, 0) of the other image.
struct alignas(64) SeenPixels {
  BlockRow z;                        // m, in the other camera's frame
  std::array<int, kBlock> u{}, v{};  // px
};

/// Returns the nearest whole number, of two equally near the even one, as cvRound does; for
/// magnitudes below 2^22.
EDVO_INLINE int rounded(float value) {
  constexpr float kOnes = 0x1.8p23F;  // the last bits of a sum with it count ones
  return std::bit_cast<int>(value + kOnes) - std::bit_cast<int>(kOnes);
}

template <typename Distort>
EDVO_INLINE void see_pixels(const PassWarp& warp, const PinholeCamera& camera,
                            const Distort& distort, const float* __restrict depth,
                            const float* __restrict rays, std::size_t count,
                            SeenPixels& __restrict seen) {
  const float max_u = static_cast<float>(camera.width) - 0.5F;
  const float max_v = static_cast<float>(camera.height) - 0.5F;
  for (std::size_t i = 0; i < count; ++i) {
    const float z = depth[i];
    const float x = z * rays[2 * i];
    const float y = z * rays[2 * i + 1];
    const float z_other = warp.R[6] * x + warp.R[7] * y + warp.R[8] * z + warp.t[2];
    const float inverse_z = 1 / (z_other > 0 ? z_other : 1);
    const ImagedDirection<float> imaged =
        image_direction(warp.projection, distort,
                        (warp.R[0] * x + warp.R[1] * y + warp.R[2] * z + warp.t[0]) * inverse_z,
                        (warp.R[3] * x + warp.R[4] * y + warp.R[5] * z + warp.t[1]) * inverse_z);
    const bool in_view = (z > 0) & (z_other > 0) & (imaged.u >= -0.5F) & (imaged.v >= -0.5F) &
                         (imaged.u < max_u) & (imaged.v < max_v);
    seen.z[i] = z_other;
    seen.u[i] = in_view ? rounded(imaged.u) : 0;
    seen.v[i] = in_view ? rounded(imaged.v) : 0;
  }
}

EDVO_INLINE void see_pixels(const PassWarp& warp, const PinholeCamera& camera, const float* depth,
                            const float* rays, std::size_t count, SeenPixels& seen) {
  dispatch_lens(warp.projection.lens, [&](const auto& distort) EDVO_INLINE_LAMBDA {
    see_pixels(warp, camera, distort, depth, rays, count, seen);
  });
}

void see_pixels_baseline(const PassWarp& warp, const PinholeCamera& camera, const float* depth,
                         const float* rays, std::size_t count, SeenPixels& seen) {
  see_pixels(warp, camera, depth, rays, count, seen);
}

EDVO_TARGET_AVX2 void see_pixels_avx2(const PassWarp& warp, const PinholeCamera& camera,
                                      const float* depth, const float* rays, std::size_t count,
                                      SeenPixels& seen) {
  see_pixels(warp, camera, depth, rays, count, seen);
}

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

}  // namespace

void add_seen_through(const PyramidLevel& own, const PyramidLevel& other, const SE3& T_other_own,
                      float evidence, ViewTiles::Values& sum) {
  const PassWarp warp(other.camera, T_other_own);
  const ViewTiles grid(own.camera);
  const bool is_baseline = available_instruction_set() == InstructionSet::baseline;
  const auto see = is_baseline ? see_pixels_baseline : see_pixels_avx2;
  SeenPixels seen;
  const auto cols = static_cast<std::size_t>(own.depth.cols);
  for (int v = 0; v < own.depth.rows; ++v) {
    for (std::size_t first = 0; first < cols; first += kBlock) {
      const std::size_t count = std::min(kBlock, cols - first);
      see(warp, other.camera, own.depth[v] + first,
          reinterpret_cast<const float*>(own.rays[v] + first), count, seen);
      for (std::size_t i = 0; i < count; ++i) {
        if (is_seen_through(seen.z[i], other.depth, seen.u[i], seen.v[i])) {
          sum[grid.of({static_cast<int>(first + i), v})] += evidence;
        }
      }
    }
  }
}

}  // namespace vo
