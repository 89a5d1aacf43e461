#include "vo/image/moved_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "vo/core/instruction_set.h"

namespace vo {
namespace {

constexpr std::size_t kMovedCells = 64;  // of two by two pixels, that are worked on together
using CellRow = std::array<float, kMovedCells>;

/// A motion of p_moved = p + r x p + t.
struct SmallMotion {
  float tx, ty, tz;  // m
  float rx, ry, rz;  // rad
};

SmallMotion small_motion(const SE3& T_moved_depth) {
  const Eigen::Matrix<float, 6, 1> tangent = T_moved_depth.log().cast<float>();
  return {tangent[0], tangent[1], tangent[2], tangent[3], tangent[4], tangent[5]};
}

/// The images that are looked up, and what for.
struct DepthLookup {
  const DepthImage& depth;
  const RayImage& rays;
  float fx, fy;  // px
  SmallMotion motion;
};

/// Numbers of both pixels of a row of each cell.
using PixelRow = std::array<float, 2 * kMovedCells>;

/// Cells side by side, each by its upper left pixel, and what is found of them.
struct alignas(64) MovedCells {
  CellRow x, y;                         // X / Z and Y / Z of the pixels' rays
  CellRow z;                            // m, depth of their points; 0 is unknown
  CellRow u, v;                         // px, where the points were seen
  CellRow stretch;                      // of depth on the way from there
  std::array<int, kMovedCells> index;   // in the image, of the pixel nearest to it
  CellRow is_inside;                    // 1, or 0 where that is beyond the border
  alignas(64) PixelRow factor, offset;  // of the pixels' depths: 1, and m where there is depth
  alignas(64) PixelRow line;            // m, moved depths of a row of pixels
};

EDVO_INLINE float farther(float a, float b) {
  return a > b ? a : b;
}

EDVO_INLINE void load(const DepthLookup& from, int v, int first, std::size_t count,
                      MovedCells& cells) {
  const float* upper = from.depth[v] + first;
  const float* lower = from.depth[v + 1] + first;
  const cv::Vec2f* rays = from.rays[v] + first;
  for (std::size_t i = 0; i < count; ++i) {
    cells.x[i] = rays[2 * i][0];
    cells.y[i] = rays[2 * i][1];
    cells.z[i] =
        farther(farther(upper[2 * i], upper[2 * i + 1]), farther(lower[2 * i], lower[2 * i + 1]));
  }
}

/// Finds where the points were seen, given what is known of their depths.
EDVO_INLINE void aim(const DepthLookup& from, float first, float v, MovedCells& cells) {
  constexpr float kBeyond = 1e6F;  // m, farther than any depth: a point that only turns
  const SmallMotion& m = from.motion;
  CellRow far;
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    far[i] = cells.z[i] > 0 ? cells.z[i] : kBeyond;
  }
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    const float x = cells.x[i];
    const float y = cells.y[i];
    const float inverse_z = 1 / far[i];
    const float turn = m.rx * y - m.ry * x;
    const float scale = 1 + turn + m.tz * inverse_z;
    const float source_x = (x - (m.ry - m.rz * y) - m.tx * inverse_z) * scale;
    const float source_y = (y - (m.rz * x - m.rx) - m.ty * inverse_z) * scale;
    cells.stretch[i] = 1 + turn;
    cells.u[i] = first + static_cast<float>(2 * static_cast<int>(i)) + from.fx * (source_x - x);
    cells.v[i] = v + from.fy * (source_y - y);
  }
}

EDVO_INLINE float clamped(float value, float last) {
  const float positive = value > 0 ? value : 0;
  return positive < last ? positive : last;
}

/// Returns the whole number nearest to one of at least 0.
EDVO_INLINE int rounded(float value) {
  constexpr float kHalf = 0.5F;
  return static_cast<int>(value + kHalf);
}

/// Finds the cells of the image nearest to where the points were seen.
EDVO_INLINE void find_cells(const DepthLookup& from, MovedCells& cells) {
  const auto last_u = static_cast<float>(from.depth.cols - 2);
  const auto last_v = static_cast<float>(from.depth.rows - 2);
  const auto stride = static_cast<int>(from.depth.step1());
  CellRow beyond_u;
  CellRow beyond_v;
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    const float u = clamped(cells.u[i], last_u);
    const float v = clamped(cells.v[i], last_v);
    beyond_u[i] = std::abs(u - cells.u[i]);
    beyond_v[i] = std::abs(v - cells.v[i]);
    cells.index[i] = rounded(v) * stride + rounded(u);
  }
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    cells.is_inside[i] = (beyond_u[i] < 0.5F ? 1.0F : 0.0F) * (beyond_v[i] < 0.5F ? 1.0F : 0.0F);
  }
}

/// Takes the depths where the points were seen for theirs, where there are any.
EDVO_INLINE void look_up(const float* depth, MovedCells& cells) {
  CellRow found;
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    found[i] = depth[cells.index[i]];
  }
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    cells.z[i] = found[i] > 0 ? found[i] : cells.z[i];
  }
}

/// Computes by what factor and offset the depths of both rows of pixels change. Both are 0 beyond
/// the border, where no depth is known.
EDVO_INLINE void find_changes(float tz, MovedCells& cells) {
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    cells.factor[2 * i] = cells.stretch[i] * cells.is_inside[i];
    cells.factor[2 * i + 1] = cells.stretch[i] * cells.is_inside[i];
  }
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    cells.offset[2 * i] = tz * cells.is_inside[i];
    cells.offset[2 * i + 1] = tz * cells.is_inside[i];
  }
}

/// Moves the depths of one of the cells' two rows of pixels. Both pixels of a cell are copied at
/// once, which is half the loads of gathering them one by one.
EDVO_INLINE void move_line(const float* depth, MovedCells& cells) {
  for (std::size_t i = 0; i < kMovedCells; ++i) {
    std::memcpy(cells.line.data() + 2 * i, depth + cells.index[i], 2 * sizeof(float));
  }
  for (std::size_t i = 0; i < cells.line.size(); ++i) {
    const float offset = cells.line[i] > 0 ? cells.offset[i] : 0;
    cells.line[i] = cells.line[i] * cells.factor[i] + offset;
  }
}

/// Writes the moved depths of a row of pixels: a whole block by its constant size, which takes a
/// few instructions, the last one by its length.
EDVO_INLINE void write_line(const MovedCells& cells, std::size_t count, float* moved) {
  if (count == kMovedCells) {
    std::memcpy(moved, cells.line.data(), sizeof(cells.line));
  } else {
    std::copy_n(cells.line.begin(), 2 * count, moved);
  }
}

EDVO_INLINE void move_image(const DepthLookup& from, DepthImage& moved) {
  constexpr auto kPixels = static_cast<int>(2 * kMovedCells);
  const float* depth = from.depth[0];
  const std::size_t stride = from.depth.step1();
  MovedCells cells{};
  for (int v = 0; v + 1 < moved.rows; v += 2) {
    for (int first = 0; first + 1 < moved.cols; first += kPixels) {
      const auto count = static_cast<std::size_t>(std::min(kPixels, moved.cols - first) / 2);
      load(from, v, first, count, cells);
      aim(from, static_cast<float>(first), static_cast<float>(v), cells);
      find_cells(from, cells);
      look_up(depth, cells);
      aim(from, static_cast<float>(first), static_cast<float>(v), cells);
      find_cells(from, cells);
      find_changes(from.motion.tz, cells);
      move_line(depth, cells);
      write_line(cells, count, moved[v] + first);
      move_line(depth + stride, cells);
      write_line(cells, count, moved[v + 1] + first);
    }
  }
}

EDVO_TARGET_AVX2 void move_image_avx2(const DepthLookup& from, DepthImage& moved) {
  move_image(from, moved);
}

EDVO_TARGET_AVX512 void move_image_avx512(const DepthLookup& from, DepthImage& moved) {
  move_image(from, moved);
}

void move_image_baseline(const DepthLookup& from, DepthImage& moved) {
  move_image(from, moved);
}

}  // namespace

void move_depth(const DepthImage& depth, const PinholeCamera& camera, const RayImage& rays,
                const SE3& T_moved_depth, DepthImage& moved) {
  make_writable(moved, depth.size());
  moved.row(moved.rows - 1).setTo(0);
  moved.col(moved.cols - 1).setTo(0);
  const InstructionSet set = available_instruction_set();
  const auto move = version_for(set, move_image_baseline, move_image_avx2, move_image_avx512);
  move({depth, rays, static_cast<float>(camera.fx), static_cast<float>(camera.fy),
        small_motion(T_moved_depth)},
       moved);
}

}  // namespace vo
