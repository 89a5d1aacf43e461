#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include "vo/geometry/line_projection.h"
#include "vo/geometry/projection.h"
#include "vo/residuals/point_pass.h"

/// The steps of point_pass.cpp for 64 points at a time, inlined into it once per instruction set.
namespace vo::detail {

inline constexpr std::size_t kBlock = 64;  // points

using BlockRow = std::array<float, kBlock>;

/// The points of one block: positions, pixels where they are seen, and residuals there.
struct alignas(64) Block {
  BlockRow x_ref, y_ref, z_ref, intensity_ref;  // m, 0..1
  BlockRow dI_dx, dI_dy, dI_dz;                 // derivatives of the reference intensity, 1/m
  BlockRow depth_sigma;                         // m
  BlockRow x, y, z, inverse_z;                  // m and 1/m, in the current camera's frame
  BlockRow du_dx, du_dy, dv_dx, dv_dy;          // derivatives of (u, v) by (X/Z, Y/Z), px
  BlockRow u, v, seen;                          // px; 0 if unseen, else at most 1
  std::array<int, kBlock> corner;               // index of the first of 4x4 pixels around (u, v)
  std::array<int, kBlock> depth_pixel;          // index of the nearest pixel of the depth image
  BlockRow intensity, gradient_u, gradient_v;   // current image's intensity; gradient, 1/px
  BlockRow weight, residual, loss;
  std::array<BlockRow, kPassParameters> J;
};

/// A pose and a camera in single precision, with the motion of both frames while they were read.
struct PassWarp {
  std::array<float, 9> R;
  std::array<float, 3> t;
  Projection<float> projection;
  SeenBounds bounds;
  ReadoutMotion ref_motion, cur_motion;
  LineProjection ref_lines, cur_lines;

  explicit PassWarp(const PointView& view) : PassWarp(view.image.camera, view.T_cur_ref) {
    ref_motion = view.points_motion;
    cur_motion = view.image_motion;
    ref_lines = LineProjection(view.image.camera, ref_motion.axis);
    cur_lines = LineProjection(view.image.camera, cur_motion.axis);
  }

  PassWarp(const PinholeCamera& camera, const SE3& T_cur_ref)
      : projection(camera),
        bounds(camera.width, camera.height),
        ref_lines(camera, ReadoutAxis::rows),
        cur_lines(camera, ReadoutAxis::rows) {
    const Eigen::Matrix3d R_cur_ref = T_cur_ref.rotation_matrix();
    Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(R.data()) = R_cur_ref.cast<float>();
    Eigen::Map<Eigen::Vector3f>(t.data()) = T_cur_ref.translation().cast<float>();
  }
};

/// Copies a whole block by its constant size, which vectorizes, the last one by its length.
EDVO_INLINE void copy_values(const float* from, std::size_t count, float* to) {
  if (count == kBlock) {
    std::memcpy(to, from, kBlock * sizeof(float));
  } else {
    std::memcpy(to, from, count * sizeof(float));
  }
}

EDVO_INLINE void load_row(const std::vector<float>& values, std::size_t first, std::size_t count,
                          BlockRow& row) {
  copy_values(values.data() + first, count, row.data());
}

EDVO_INLINE void store_row(const BlockRow& row, std::size_t first, std::size_t count,
                           std::vector<float>& values) {
  copy_values(row.data(), count, values.data() + first);
}

EDVO_INLINE void load_points(const EdgePointLevel& points, std::size_t first, std::size_t count,
                             Block& block) {
  if (count < kBlock) {
    block.z_ref.fill(1);
  }
  load_row(points.x_ref, first, count, block.x_ref);
  load_row(points.y_ref, first, count, block.y_ref);
  load_row(points.z_ref, first, count, block.z_ref);
  load_row(points.intensity, first, count, block.intensity_ref);
}

/// Projects a block's points with the lens's distortion function, `distort`.
template <typename Distort>
EDVO_INLINE void distort_block(const PassWarp& warp, const Distort& distort, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const ImagedDirection<float> imaged = image_direction(
        warp.projection, distort, block.x[i] * block.inverse_z[i], block.y[i] * block.inverse_z[i]);
    block.u[i] = imaged.u;
    block.v[i] = imaged.v;
    block.du_dx[i] = imaged.du_dx;
    block.du_dy[i] = imaged.du_dy;
    block.dv_dx[i] = imaged.dv_dx;
    block.dv_dy[i] = imaged.dv_dy;
  }
}

/// Moves points by `share` of the motion of the line that sees them: 1 moves from their line's
/// camera to the middle line's, -1 back. Lens distortion is ignored in finding the line.
EDVO_INLINE void roll_points(const LineProjection& lines, const ReadoutMotion& motion, float share,
                             BlockRow& xs, BlockRow& ys, BlockRow& zs) {
  const Eigen::Vector3f w = motion.angular;
  const Eigen::Vector3f v = motion.linear;
  const bool by_row = motion.axis == ReadoutAxis::rows;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = xs[i];
    const float y = ys[i];
    const float z = zs[i];
    const float past = share * lines.past_middle((by_row ? y : x) / z);
    xs[i] = x + past * (w[1] * z - w[2] * y + v[0]);
    ys[i] = y + past * (w[2] * x - w[0] * z + v[1]);
    zs[i] = z + past * (w[0] * y - w[1] * x + v[2]);
  }
}

EDVO_INLINE void warp_block(const PassWarp& warp, std::size_t count, Block& block) {
  if (!warp.ref_motion.is_zero()) {
    roll_points(warp.ref_lines, warp.ref_motion, 1, block.x_ref, block.y_ref, block.z_ref);
  }
  BlockRow front;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = block.x_ref[i];
    const float y = block.y_ref[i];
    const float z = block.z_ref[i];
    const float z_cur = warp.R[6] * x + warp.R[7] * y + warp.R[8] * z + warp.t[2];
    const bool in_front = z_cur > kMinVisibleDepth;
    block.x[i] = warp.R[0] * x + warp.R[1] * y + warp.R[2] * z + warp.t[0];
    block.y[i] = warp.R[3] * x + warp.R[4] * y + warp.R[5] * z + warp.t[1];
    block.z[i] = in_front ? z_cur : 1;
    front[i] = in_front ? 1 : 0;
  }
  if (!warp.cur_motion.is_zero()) {
    roll_points(warp.cur_lines, warp.cur_motion, -1, block.x, block.y, block.z);
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    block.inverse_z[i] = 1 / block.z[i];
  }
  dispatch_lens(warp.projection.lens, [&](const auto& distort) EDVO_INLINE_LAMBDA {
    distort_block(warp, distort, block);
  });
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float u = block.u[i];
    const float v = block.v[i];
    const float seen = warp.bounds.holds(u, v) ? front[i] : 0;
    block.seen[i] = seen;
    block.u[i] = seen > 0 ? u : 1;
    block.v[i] = seen > 0 ? v : 1;
  }
  for (std::size_t i = count; i < kBlock; ++i) {
    block.seen[i] = 0;
    block.u[i] = 1;
    block.v[i] = 1;
  }
}

/// Four neighbouring pixels in a row of the image.
using Quad = float __attribute__((vector_size(16)));

EDVO_INLINE Quad load_quad(const float* pixels) {
  Quad quad;
  std::memcpy(&quad, pixels, sizeof(quad));
  return quad;
}

/// Rows of four pixels around each point, interpolated in v: intensities and differences in v.
struct alignas(64) BlockQuads {
  std::array<Quad, kBlock> value;
  std::array<Quad, kBlock> slope;
};

/// Finds the pixels around each point, and prefetches the rows of them from `first_row` on that
/// will be read: they are too far apart for the processor to do so.
EDVO_INLINE void find_corners(const GrayImage& image, std::ptrdiff_t first_row, std::ptrdiff_t rows,
                              Block& block) {
  const auto* pixels = reinterpret_cast<const float*>(image.data);
  const auto stride = static_cast<std::ptrdiff_t>(image.step1());
  for (std::size_t i = 0; i < kBlock; ++i) {
    const int u0 = static_cast<int>(block.u[i]);
    const int v0 = static_cast<int>(block.v[i]);
    block.corner[i] = (v0 - 1) * static_cast<int>(stride) + (u0 - 1);
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float* corner = pixels + block.corner[i];
    for (std::ptrdiff_t row = first_row; row < first_row + rows; ++row) {
      __builtin_prefetch(corner + row * stride);
    }
  }
}

EDVO_INLINE void load_quads(const GrayImage& image, const Block& block, BlockQuads& quads) {
  const auto* pixels = reinterpret_cast<const float*>(image.data);
  const auto stride = static_cast<std::ptrdiff_t>(image.step1());
  BlockRow above_v;
  for (std::size_t i = 0; i < kBlock; ++i) {
    above_v[i] = block.v[i] - static_cast<float>(static_cast<int>(block.v[i]));
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float* corner = pixels + block.corner[i];
    const float dv = above_v[i];
    const Quad row0 = load_quad(corner);
    const Quad row1 = load_quad(corner + stride);
    const Quad row2 = load_quad(corner + 2 * stride);
    const Quad row3 = load_quad(corner + 3 * stride);
    const Quad upper = row2 - row0;
    quads.value[i] = row1 + (row2 - row1) * dv;
    quads.slope[i] = upper + ((row3 - row1) - upper) * dv;
  }
}

/// Samples the intensity alone, interpolated bilinearly, to the same bits as with its differences.
EDVO_INLINE void sample_block_intensity(const GrayImage& image, Block& block) {
  const auto* pixels = reinterpret_cast<const float*>(image.data);
  const auto stride = static_cast<std::ptrdiff_t>(image.step1());
  alignas(64) std::array<std::array<float, 4>, kBlock> corners;  // two pixels of two rows each
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float* upper = pixels + block.corner[i] + stride + 1;
    std::memcpy(corners[i].data(), upper, 2 * sizeof(float));
    std::memcpy(corners[i].data() + 2, upper + stride, 2 * sizeof(float));
  }
  const float* corner = corners.front().data();
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float du = block.u[i] - static_cast<float>(static_cast<int>(block.u[i]));
    const float dv = block.v[i] - static_cast<float>(static_cast<int>(block.v[i]));
    const float left = corner[4 * i] + (corner[4 * i + 2] - corner[4 * i]) * dv;
    const float right = corner[4 * i + 1] + (corner[4 * i + 3] - corner[4 * i + 1]) * dv;
    block.intensity[i] = left + (right - left) * du;
  }
}

/// Samples the intensity and its central differences, both interpolated bilinearly.
EDVO_INLINE void sample_block(const GrayImage& image, Block& block) {
  BlockQuads quads;
  load_quads(image, block, quads);
  const auto* value = reinterpret_cast<const float*>(quads.value.data());
  const auto* slope = reinterpret_cast<const float*>(quads.slope.data());
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float du = block.u[i] - static_cast<float>(static_cast<int>(block.u[i]));
    const float v0 = value[4 * i];
    const float v1 = value[4 * i + 1];
    const float v2 = value[4 * i + 2];
    const float v3 = value[4 * i + 3];
    const float s1 = slope[4 * i + 1];
    const float s2 = slope[4 * i + 2];
    const float left = v2 - v0;
    block.intensity[i] = v1 + (v2 - v1) * du;
    block.gradient_u[i] = 0.5F * (left + ((v3 - v1) - left) * du);
    block.gradient_v[i] = 0.5F * (s1 + (s2 - s1) * du);
  }
}

/// Finds the pixel of the depth image that is nearest to each point, and prefetches it. Seen points
/// lie at 1 px or beyond, where adding one half and cutting off rounds to the nearest.
EDVO_INLINE void find_depth_pixels(const DepthImage& depth, Block& block) {
  const auto* pixels = reinterpret_cast<const float*>(depth.data);
  const auto stride = static_cast<int>(depth.step1());
  for (std::size_t i = 0; i < kBlock; ++i) {
    const auto u = static_cast<int>(block.u[i] + 0.5F);  // NOLINT(bugprone-incorrect-roundings)
    const auto v = static_cast<int>(block.v[i] + 0.5F);  // NOLINT(bugprone-incorrect-roundings)
    block.depth_pixel[i] = v * stride + u;
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    __builtin_prefetch(pixels + block.depth_pixel[i]);
  }
}

/// Marks points as unseen whose depth differs from the one measured there by more than `max_ratio`.
EDVO_INLINE void test_depth(const DepthImage& depth, float max_ratio, std::size_t count,
                            Block& block) {
  const auto* pixels = reinterpret_cast<const float*>(depth.data);
  BlockRow measured{};
  for (std::size_t i = 0; i < count; ++i) {
    measured[i] = pixels[block.depth_pixel[i]];
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float z = block.z[i];
    const float there = measured[i];
    const bool hidden = (there > 0) & ((z > there * max_ratio) | (z * max_ratio < there));
    block.seen[i] = hidden ? 0 : block.seen[i];
  }
}

/// Adds `share` times the reference's derivatives by position, turned into the current camera's
/// frame, to those of the Jacobian.
EDVO_INLINE void add_reference(const PassWarp& warp, float share, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = share * block.dI_dx[i];
    const float y = share * block.dI_dy[i];
    const float z = share * block.dI_dz[i];
    block.J[0][i] += warp.R[0] * x + warp.R[1] * y + warp.R[2] * z;
    block.J[1][i] += warp.R[3] * x + warp.R[4] * y + warp.R[5] * z;
    block.J[2][i] += warp.R[6] * x + warp.R[7] * y + warp.R[8] * z;
  }
}

/// Completes derivatives q by the position p to those by the pose increment, [q; p x q].
EDVO_INLINE void complete_rotations(Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float qx = block.J[0][i];
    const float qy = block.J[1][i];
    const float qz = block.J[2][i];
    block.J[3][i] = block.y[i] * qz - block.z[i] * qy;
    block.J[4][i] = block.z[i] * qx - block.x[i] * qz;
    block.J[5][i] = block.x[i] * qy - block.y[i] * qx;
  }
}

/// Computes the rows of the Jacobian. The derivative q by the point's position p gives the
/// derivative by the pose increment: [q; p x q] (paper, Eq. 12).
EDVO_INLINE void differentiate_block(const PassWarp& warp, const PassOptions& options,
                                     Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float a = (block.gradient_u[i] * block.du_dx[i] + block.gradient_v[i] * block.dv_dx[i]) *
                    block.inverse_z[i];
    const float b = (block.gradient_u[i] * block.du_dy[i] + block.gradient_v[i] * block.dv_dy[i]) *
                    block.inverse_z[i];
    block.J[0][i] = options.current_share * a;
    block.J[1][i] = options.current_share * b;
    block.J[2][i] =
        options.current_share * (-(a * block.x[i] + b * block.y[i]) * block.inverse_z[i]);
  }
  if (options.reference_share > 0) {
    add_reference(warp, options.reference_share, block);
  }
  complete_rotations(block);
  for (std::size_t i = 0; i < kBlock; ++i) {
    block.J[6][i] = -block.intensity_ref[i];
    block.J[7][i] = -1;
  }
}

/// Lowers each residual's weight by the uncertainty of its point's depth: moving the point along
/// its ray by sigma changes the residual by q . (p - t) / z_ref sigma.
EDVO_INLINE void weigh_by_depth(const PassWarp& warp, const PassOptions& options, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float along_ray = block.J[0][i] * (block.x[i] - warp.t[0]) +
                            block.J[1][i] * (block.y[i] - warp.t[1]) +
                            block.J[2][i] * (block.z[i] - warp.t[2]);
    const float sigma = along_ray / block.z_ref[i] * block.depth_sigma[i];
    block.seen[i] = block.seen[i] / (1 + sigma * sigma * options.inverse_variance);
  }
}

template <RobustLoss kLoss>
EDVO_INLINE void weigh_block(const PassOptions& options, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float r = block.intensity[i] - (options.gain * block.intensity_ref[i] + options.offset);
    const RobustValue robust = robust_value<kLoss>(r, options.loss_scale);
    block.residual[i] = r;
    block.weight[i] =
        block.seen[i] * (options.squared_weights ? robust.weight * robust.weight : robust.weight);
    block.loss[i] = block.seen[i] * robust.loss;
  }
}

EDVO_INLINE void weigh_by_loss(const PassOptions& options, Block& block) {
  switch (options.loss) {
    case RobustLoss::huber:
      return weigh_block<RobustLoss::huber>(options, block);
    case RobustLoss::tukey:
      return weigh_block<RobustLoss::tukey>(options, block);
    case RobustLoss::student_t:
      return weigh_block<RobustLoss::student_t>(options, block);
    default:
      return weigh_block<RobustLoss::none>(options, block);
  }
}

/// Finds where the `count` points from `first` on are seen.
EDVO_INLINE void locate_block(const PointView& view, const PassOptions& options,
                              const PassWarp& warp, std::size_t first, std::size_t count,
                              Block& block) {
  load_points(view.points, first, count, block);
  warp_block(warp, count, block);
  find_corners(view.image.intensity, 0, 4, block);
  if (options.max_depth_ratio > 0) {
    find_depth_pixels(view.image.depth, block);
  }
}

/// Computes residuals, weights and Jacobians of the `count` points from `first` on, which have been
/// located.
EDVO_INLINE void linearize_block(const PointView& view, const PassOptions& options,
                                 const PassWarp& warp, std::size_t first, std::size_t count,
                                 Block& block) {
  const EdgePointLevel& points = view.points;
  sample_block(view.image.intensity, block);
  if (options.max_depth_ratio > 0) {
    test_depth(view.image.depth, options.max_depth_ratio, count, block);
  }
  if (options.reference_share > 0) {
    load_row(points.dI_dx, first, count, block.dI_dx);
    load_row(points.dI_dy, first, count, block.dI_dy);
    load_row(points.dI_dz, first, count, block.dI_dz);
  }
  differentiate_block(warp, options, block);
  if (options.inverse_variance > 0) {
    load_row(points.depth_sigma, first, count, block.depth_sigma);
    weigh_by_depth(warp, options, block);
  }
  weigh_by_loss(options, block);
}

/// Calls `use(first, count, block)` with one block of linearized points after the other. Each is
/// located while the memory around the one before is on its way.
template <typename Use>
EDVO_INLINE void for_each_linearized(const PointView& view, const PassOptions& options,
                                     const Use& use) {
  std::array<Block, 2> blocks{};
  const PassWarp warp(view);
  const std::size_t size = view.points.size();
  for (std::size_t next = 0; next < size + kBlock; next += kBlock) {
    if (next < size) {
      locate_block(view, options, warp, next, std::min(kBlock, size - next),
                   blocks[next / kBlock % 2]);
    }
    if (next >= kBlock) {
      const std::size_t first = next - kBlock;
      const std::size_t count = std::min(kBlock, size - first);
      Block& block = blocks[first / kBlock % 2];
      linearize_block(view, options, warp, first, count, block);
      use(first, count, block);
    }
  }
}

}  // namespace vo::detail
