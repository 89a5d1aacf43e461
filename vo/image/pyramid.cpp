#include "vo/image/pyramid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"
#include "vo/core/instruction_set.h"
#include "vo/image/cubic_depth.h"
#include "vo/image/gray_without_vignette.h"

namespace vo {
namespace {

constexpr int kMinSize = 20;              // px, of the smallest level's shorter side
constexpr float kMaxDepthSpread = 1.05F;  // farthest over nearest of four depths on one surface
constexpr float kFar = 1e6F;              // m, beyond any measured depth

EDVO_INLINE float lesser(float a, float b) {
  return a < b ? a : b;
}

EDVO_INLINE float greater(float a, float b) {
  return a > b ? a : b;
}

constexpr std::size_t kPixelsPerBlock = 64;  // pixels of the halved image

EDVO_INLINE void put_holes_far(const float* depth, std::size_t count, float* __restrict far) {
  for (std::size_t u = 0; u < count; ++u) {
    far[u] = depth[u] > 0 ? depth[u] : kFar;
  }
}

/// Computes at most 64 pixels of `halve_depth`, in loops that the compiler vectorizes one by one.
EDVO_INLINE void merge_block(const float* upper, const float* lower, std::size_t count,
                             float* __restrict merged) {
  std::array<float, 2 * kPixelsPerBlock> upper_far;
  std::array<float, 2 * kPixelsPerBlock> lower_far;
  std::array<float, kPixelsPerBlock> nearest;
  std::array<float, kPixelsPerBlock> farthest;
  put_holes_far(upper, 2 * count, upper_far.data());
  put_holes_far(lower, 2 * count, lower_far.data());
  for (std::size_t u = 0; u < count; ++u) {
    const float a = upper_far[2 * u];
    const float b = upper_far[2 * u + 1];
    const float c = lower_far[2 * u];
    const float d = lower_far[2 * u + 1];
    nearest[u] = lesser(lesser(a, b), lesser(c, d));
    farthest[u] = greater(greater(a, b), greater(c, d));
    merged[u] = 4 * (a * b) * (c * d) / ((a + b) * (c * d) + (c + d) * (a * b));
  }
  for (std::size_t u = 0; u < count; ++u) {
    merged[u] = farthest[u] <= kMaxDepthSpread * nearest[u] ? merged[u] : nearest[u];
  }
  for (std::size_t u = 0; u < count; ++u) {
    merged[u] = merged[u] < kFar / 2 ? merged[u] : 0;
  }
}

EDVO_INLINE void merge_depth(const DepthImage& depth, DepthImage& half) {
  const auto cols = static_cast<std::size_t>(half.cols);
  for (int v = 0; v < half.rows; ++v) {
    const float* upper = depth[2 * v];
    const float* lower = depth[2 * v + 1];
    std::size_t u = 0;
    for (; u + kPixelsPerBlock <= cols; u += kPixelsPerBlock) {
      merge_block(upper + 2 * u, lower + 2 * u, kPixelsPerBlock, half[v] + u);
    }
    merge_block(upper + 2 * u, lower + 2 * u, cols - u, half[v] + u);
  }
}

EDVO_TARGET_AVX2 void merge_depth_avx2(const DepthImage& depth, DepthImage& half) {
  merge_depth(depth, half);
}

EDVO_TARGET_AVX512 void merge_depth_avx512(const DepthImage& depth, DepthImage& half) {
  merge_depth(depth, half);
}

void merge_depth_baseline(const DepthImage& depth, DepthImage& half) {
  merge_depth(depth, half);
}

/// Computes a row of means of four pixels from two rows.
EDVO_INLINE void average_row(const float* upper, const float* lower, int cols,
                             float* __restrict means) {
  for (int u = 0; u < cols; ++u) {
    means[u] = 0.25F * ((upper[2 * u] + upper[2 * u + 1]) + (lower[2 * u] + lower[2 * u + 1]));
  }
}

EDVO_TARGET_AVX2 void average_avx2(const float* upper, const float* lower, int cols, float* means) {
  average_row(upper, lower, cols, means);
}

void average_baseline(const float* upper, const float* lower, int cols, float* means) {
  average_row(upper, lower, cols, means);
}

/// Returns the luma (ITU-R BT.601) of a ColorImage, in `memory`, or a ByteImage itself.
ByteImage luma_of(const cv::Mat& image, ByteImage& memory) {
  if (image.channels() != 3) {
    return image;
  }
  cv::cvtColor(image, memory, cv::COLOR_BGR2GRAY);
  return memory;
}

PinholeCamera halved_camera(const PinholeCamera& camera, HalvedPrincipalPoint principal_point) {
  PinholeCamera half = camera.halved();
  if (principal_point == HalvedPrincipalPoint::plain) {
    half.cx = camera.cx / 2;
    half.cy = camera.cy / 2;
  }
  return half;
}

RayImage pixel_rays(const PinholeCamera& camera) {
  RayImage rays(camera.height, camera.width);
  for (int v = 0; v < rays.rows; ++v) {
    for (int u = 0; u < rays.cols; ++u) {
      const Eigen::Vector3d ray = camera.unproject({u, v}, 1);
      rays(v, u) = {static_cast<float>(ray.x()), static_cast<float>(ray.y())};
    }
  }
  return rays;
}

/// Returns the pixels in which the lens shows nothing: their rays are no numbers. Empty where there
/// are none.
ByteImage pixels_without_ray(const RayImage& rays) {
  ByteImage unseen(rays.size(), uchar{0});
  for (int v = 0; v < rays.rows; ++v) {
    for (int u = 0; u < rays.cols; ++u) {
      const bool is_seen = std::isfinite(rays(v, u)[0]) && std::isfinite(rays(v, u)[1]);
      unseen(v, u) = is_seen ? 0 : 255;
    }
  }
  return cv::countNonZero(unseen) > 0 ? unseen : ByteImage();
}

CameraLevel level_of(const PinholeCamera& camera) {
  CameraLevel level{camera, pixel_rays(camera), {}};
  level.unseen = pixels_without_ray(level.rays);
  return level;
}

/// Removes depth, which others may share, where the lens shows nothing.
void take_out_unseen(const CameraLevel& level, DepthImage& depth) {
  if (!level.unseen.empty() && !depth.empty()) {
    depth = depth.clone();
    depth.setTo(0, level.unseen);
  }
}

}  // namespace

void PyramidOptions::validate() const {
  require(levels >= 1 && levels <= 8, "pyramid.levels: expected 1 to 8, got ", levels);
}

void halve(const GrayImage& image, GrayImage& half) {
  make_writable(half, {image.cols / 2, image.rows / 2});
  const auto average =
      available_instruction_set() == InstructionSet::baseline ? average_baseline : average_avx2;
  for (int v = 0; v < half.rows; ++v) {
    average(image[2 * v], image[2 * v + 1], half.cols, half[v]);
  }
}

void halve_depth(const DepthImage& depth, DepthImage& half) {
  make_writable(half, {depth.cols / 2, depth.rows / 2});
  const InstructionSet set = available_instruction_set();
  const auto merge = version_for(set, merge_depth_baseline, merge_depth_avx2, merge_depth_avx512);
  merge(depth, half);
}

cv::Vec2f central_gradient(const GrayImage& image, cv::Point pixel) {
  const auto [u, v] = std::pair{pixel.x, pixel.y};
  if (u < 1 || v < 1 || u + 1 >= image.cols || v + 1 >= image.rows) {
    return {0, 0};
  }
  return {0.5F * (image(v, u + 1) - image(v, u - 1)), 0.5F * (image(v + 1, u) - image(v - 1, u))};
}

std::vector<CameraLevel> camera_levels(const PinholeCamera& camera, const PyramidOptions& options) {
  std::vector<CameraLevel> levels{level_of(camera)};
  while (static_cast<int>(levels.size()) < options.levels) {
    const PinholeCamera half = halved_camera(levels.back().camera, options.principal_point);
    if (std::min(half.width, half.height) < kMinSize) {
      break;
    }
    levels.push_back(level_of(half));
  }
  return levels;
}

PyramidBuilder::PyramidBuilder(const PinholeCamera& camera, const PyramidOptions& options)
    : options_(options), levels_(camera_levels(camera, options)) {}

void PyramidBuilder::build(const RgbdFrame& frame, const Vignette& vignette,
                           FramePyramid& pyramid) {
  pyramid.timestamp = frame.timestamp;
  pyramid.vignette = vignette;
  pyramid.levels.resize(levels_.size());
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    PyramidLevel& level = pyramid.levels[l];
    level.camera = levels_[l].camera;
    level.rays = levels_[l].rays;
    if (l == 0) {
      to_gray_without(vignette, level.camera, luma_of(frame.image, luma_), level.intensity);
      level.depth = frame.depth;
    } else {
      halve(pyramid.levels[l - 1].intensity, level.intensity);
      halve_depth_into(pyramid.levels[l - 1].depth, level.depth);
    }
    take_out_unseen(levels_[l], level.depth);
  }
}

void PyramidBuilder::halve_depth_into(const DepthImage& depth, DepthImage& half) const {
  if (options_.depth == HalvedDepth::surfaces) {
    halve_depth(depth, half);
  } else {
    halve_cubic(depth, half);
  }
}

FramePyramid build_pyramid(const RgbdFrame& frame, const PinholeCamera& camera,
                           const PyramidOptions& options) {
  FramePyramid pyramid;
  PyramidBuilder(camera, options).build(frame, {}, pyramid);
  return pyramid;
}

void add_edges(FramePyramid& pyramid, EdgeFinder& finder) {
  for (PyramidLevel& level : pyramid.levels) {
    finder.detect(level.intensity, level.edges);
  }
}

void add_edges(FramePyramid& pyramid, const EdgeOptions& options) {
  EdgeFinder finder(options);
  add_edges(pyramid, finder);
}

std::size_t memory_bytes(const FramePyramid& pyramid) {
  std::size_t bytes = 0;
  for (const PyramidLevel& level : pyramid.levels) {
    for (const cv::Mat* image :
         {static_cast<const cv::Mat*>(&level.intensity), static_cast<const cv::Mat*>(&level.edges),
          static_cast<const cv::Mat*>(&level.depth)}) {
      bytes += image->total() * image->elemSize();
    }
  }
  return bytes;
}

bool is_noticeable(const Vignette& removed, const Vignette& vignette) {
  constexpr double kNoticeable = 0.01;  // share of the intensity at the corners
  const Eigen::Vector2d corner = Eigen::Vector2d::Ones();
  return std::abs(vignette.gain(corner) - removed.gain(corner)) > kNoticeable;
}

FramePyramid without_vignette(FramePyramid pyramid, const Vignette& vignette) {
  for (PyramidLevel& level : pyramid.levels) {
    level.intensity = level.intensity.clone();  // other copies of the frame keep theirs
    take_out(vignette, level.camera, pyramid.vignette, level.intensity);
  }
  pyramid.vignette = vignette;
  return pyramid;
}

}  // namespace vo
