#include "vo/image/pyramid.h"

#include <algorithm>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"
#include "vo/core/instruction_set.h"

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

/// One row of `halve_depth`, in steps that are vectorized each.
class DepthRowMerger {
 public:
  explicit DepthRowMerger(int cols)
      : upper_(2 * static_cast<std::size_t>(cols)),
        lower_(upper_.size()),
        nearest_(static_cast<std::size_t>(cols)),
        farthest_(nearest_.size()) {}

  EDVO_INLINE void merge(const float* upper, const float* lower, float* __restrict merged) {
    put_holes_far(upper, upper_);
    put_holes_far(lower, lower_);
    const std::size_t cols = nearest_.size();
    float* __restrict nearest = nearest_.data();
    float* __restrict farthest = farthest_.data();
    for (std::size_t u = 0; u < cols; ++u) {
      const float a = upper_[2 * u];
      const float b = upper_[2 * u + 1];
      const float c = lower_[2 * u];
      const float d = lower_[2 * u + 1];
      nearest[u] = lesser(lesser(a, b), lesser(c, d));
      farthest[u] = greater(greater(a, b), greater(c, d));
      merged[u] = 4 * (a * b) * (c * d) / ((a + b) * (c * d) + (c + d) * (a * b));
    }
    for (std::size_t u = 0; u < cols; ++u) {
      merged[u] = farthest[u] <= kMaxDepthSpread * nearest[u] ? merged[u] : nearest[u];
    }
    for (std::size_t u = 0; u < cols; ++u) {
      merged[u] = merged[u] < kFar / 2 ? merged[u] : 0;
    }
  }

 private:
  EDVO_INLINE static void put_holes_far(const float* depth, std::vector<float>& row) {
    for (std::size_t u = 0; u < row.size(); ++u) {
      row[u] = depth[u] > 0 ? depth[u] : kFar;
    }
  }

  std::vector<float> upper_, lower_;       ///< m, of the finer level
  std::vector<float> nearest_, farthest_;  ///< m, of each four
};

EDVO_INLINE void merge_depth(const DepthImage& depth, DepthImage& half) {
  DepthRowMerger merger(half.cols);
  for (int v = 0; v < half.rows; ++v) {
    merger.merge(depth[2 * v], depth[2 * v + 1], half[v]);
  }
}

EDVO_TARGET_AVX2 void merge_depth_avx2(const DepthImage& depth, DepthImage& half) {
  merge_depth(depth, half);
}

void merge_depth_baseline(const DepthImage& depth, DepthImage& half) {
  merge_depth(depth, half);
}

PinholeCamera halved_camera(const PinholeCamera& camera, HalvedPrincipalPoint principal_point) {
  PinholeCamera half = camera.halved();
  if (principal_point == HalvedPrincipalPoint::plain) {
    half.cx = camera.cx / 2;
    half.cy = camera.cy / 2;
  }
  return half;
}

DepthImage halved_depth(const DepthImage& depth, HalvedDepth how) {
  if (how == HalvedDepth::surfaces) {
    return halve_depth(depth);
  }
  DepthImage half;
  cv::resize(depth, half, {depth.cols / 2, depth.rows / 2}, 0, 0, cv::INTER_CUBIC);
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

}  // namespace

void PyramidOptions::validate() const {
  require(levels >= 1 && levels <= 8, "pyramid.levels: expected 1 to 8, got ", levels);
}

GrayImage halve(const GrayImage& image) {
  GrayImage half(image.rows / 2, image.cols / 2);
  for (int v = 0; v < half.rows; ++v) {
    const float* upper = image[2 * v];
    const float* lower = image[2 * v + 1];
    float* target = half[v];
    for (int u = 0; u < half.cols; ++u) {
      target[u] = 0.25F * ((upper[2 * u] + upper[2 * u + 1]) + (lower[2 * u] + lower[2 * u + 1]));
    }
  }
  return half;
}

DepthImage halve_depth(const DepthImage& depth) {
  DepthImage half(depth.rows / 2, depth.cols / 2);
  if (available_instruction_set() == InstructionSet::baseline) {
    merge_depth_baseline(depth, half);
  } else {
    merge_depth_avx2(depth, half);
  }
  return half;
}

cv::Vec2f central_gradient(const GrayImage& image, cv::Point pixel) {
  const auto [u, v] = std::pair{pixel.x, pixel.y};
  if (u < 1 || v < 1 || u + 1 >= image.cols || v + 1 >= image.rows) {
    return {0, 0};
  }
  return {0.5F * (image(v, u + 1) - image(v, u - 1)), 0.5F * (image(v + 1, u) - image(v - 1, u))};
}

std::vector<CameraLevel> camera_levels(const PinholeCamera& camera, const PyramidOptions& options) {
  std::vector<CameraLevel> levels{{camera, pixel_rays(camera)}};
  while (static_cast<int>(levels.size()) < options.levels) {
    const PinholeCamera half = halved_camera(levels.back().camera, options.principal_point);
    if (std::min(half.width, half.height) < kMinSize) {
      break;
    }
    levels.push_back({half, pixel_rays(half)});
  }
  return levels;
}

FramePyramid build_pyramid(const RgbdFrame& frame, const std::vector<CameraLevel>& levels,
                           const PyramidOptions& options, const Vignette& vignette) {
  FramePyramid pyramid{frame.timestamp, {}, vignette};
  for (const CameraLevel& level : levels) {
    if (pyramid.levels.empty()) {
      GrayImage intensity = to_gray(frame.image);
      take_out(vignette, level.camera, {}, intensity);
      pyramid.levels.push_back({level.camera, level.rays, std::move(intensity), {}, frame.depth});
    } else {
      const PyramidLevel& finer = pyramid.levels.back();
      pyramid.levels.push_back({level.camera,
                                level.rays,
                                halve(finer.intensity),
                                {},
                                halved_depth(finer.depth, options.depth)});
    }
  }
  return pyramid;
}

FramePyramid build_pyramid(const RgbdFrame& frame, const PinholeCamera& camera,
                           const PyramidOptions& options) {
  return build_pyramid(frame, camera_levels(camera, options), options);
}

void add_edges(FramePyramid& pyramid, const EdgeFinder& finder) {
  for (PyramidLevel& level : pyramid.levels) {
    level.edges = finder.detect(level.intensity);
  }
}

void add_edges(FramePyramid& pyramid, const EdgeOptions& options) {
  add_edges(pyramid, EdgeFinder(options));
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

}  // namespace vo
