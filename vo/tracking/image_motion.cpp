#include "vo/tracking/image_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "vo/core/instruction_set.h"
#include "vo/residuals/warp.h"

namespace vo {
namespace {

constexpr std::size_t kBlock = 64;  // points

using BlockRow = std::array<float, kBlock>;

/// The points of one block, and where they are in the current frame.
struct alignas(64) Block {
  BlockRow x, y, z;              // m, in the points' frame
  BlockRow u_ref, v_ref;         // px, the points' own pixels
  BlockRow in_view, squared_px;  // 0 or 1; squared displacement, 0 out of view

  void load(const EdgePointLevel& points, std::size_t first) {
    const std::size_t count = std::min(kBlock, points.size() - first);
    z.fill(-1);  // behind the camera
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = points.x_ref[first + i];
      y[i] = points.y_ref[first + i];
      z[i] = points.z_ref[first + i];
      u_ref[i] = static_cast<float>(points.pixel[first + i].x);
      v_ref[i] = static_cast<float>(points.pixel[first + i].y);
    }
  }
};

/// The warp of points and the image that they are looked for in.
struct MotionWarp {
  std::array<float, 9> R;
  std::array<float, 3> t;  // m
  Projection<float> projection;
  float max_u, max_v;  // px, where the image ends

  MotionWarp(const PinholeCamera& camera, const SE3& T_cur_ref)
      : projection(camera),
        max_u(static_cast<float>(camera.width) - 0.5F),
        max_v(static_cast<float>(camera.height) - 0.5F) {
    const Warp<float> warp(camera, T_cur_ref);
    Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(R.data()) = warp.R_cur_ref;
    Eigen::Map<Eigen::Vector3f>(t.data()) = warp.t_cur_ref;
  }
};

template <typename Distort>
EDVO_INLINE void move_block(const MotionWarp& warp, const Distort& distort, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = block.x[i];
    const float y = block.y[i];
    const float z = block.z[i];
    const float z_cur = warp.R[6] * x + warp.R[7] * y + warp.R[8] * z + warp.t[2];
    const float inverse_z = 1 / (z_cur > 0 ? z_cur : 1);
    const ImagedDirection<float> imaged =
        image_direction(warp.projection, distort,
                        (warp.R[0] * x + warp.R[1] * y + warp.R[2] * z + warp.t[0]) * inverse_z,
                        (warp.R[3] * x + warp.R[4] * y + warp.R[5] * z + warp.t[1]) * inverse_z);
    const bool in_view = (z > 0) & (z_cur > 0) & (imaged.u >= -0.5F) & (imaged.v >= -0.5F) &
                         (imaged.u < warp.max_u) & (imaged.v < warp.max_v);
    const float du = imaged.u - block.u_ref[i];
    const float dv = imaged.v - block.v_ref[i];
    block.in_view[i] = in_view ? 1 : 0;
    block.squared_px[i] = in_view ? du * du + dv * dv : 0;
  }
}

EDVO_INLINE void move_block(const MotionWarp& warp, Block& block) {
  dispatch_lens(warp.projection.lens,
                [&](const auto& distort) EDVO_INLINE_LAMBDA { move_block(warp, distort, block); });
}

void move_baseline(const MotionWarp& warp, Block& block) {
  move_block(warp, block);
}

EDVO_TARGET_AVX2 void move_avx2(const MotionWarp& warp, Block& block) {
  move_block(warp, block);
}

}  // namespace

ImageMotion image_motion(const EdgePoints& points, const FramePyramid& frame,
                         const SE3& T_cur_ref) {
  const EdgePointLevel& level = points.levels.back();
  const PinholeCamera& camera = frame.levels.back().camera;
  const MotionWarp warp(camera, T_cur_ref);
  const bool is_baseline = available_instruction_set() == InstructionSet::baseline;
  const auto move = is_baseline ? move_baseline : move_avx2;
  Block block{};
  ImageMotion motion;
  double seen = 0;
  for (std::size_t first = 0; first < level.size(); first += kBlock) {
    block.load(level, first);
    move(warp, block);
    for (std::size_t i = 0; i < kBlock; ++i) {
      seen += static_cast<double>(block.in_view[i]);
      motion.flow_px += std::sqrt(static_cast<double>(block.squared_px[i]));
    }
  }
  if (seen > 0) {
    const double finest_px = frame.levels.front().camera.fx / camera.fx;
    motion.flow_px *= finest_px / seen;
    motion.overlap = seen / static_cast<double>(level.size());
  }
  return motion;
}

}  // namespace vo
