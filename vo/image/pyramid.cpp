#include "vo/image/pyramid.h"

#include <algorithm>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr int kMinSize = 20;              // px, of the smallest level's shorter side
constexpr float kMaxDepthSpread = 1.05F;  // farthest over nearest of four depths on one surface

float merged_depth(float a, float b, float c, float d) {
  const auto nearest_of = [](float x, float y) {
    return has_depth(x) && (!has_depth(y) || x < y) ? x : y;
  };
  const float nearest = nearest_of(nearest_of(a, b), nearest_of(c, d));
  const bool all_measured = has_depth(a) && has_depth(b) && has_depth(c) && has_depth(d);
  if (!all_measured || std::max({a, b, c, d}) > kMaxDepthSpread * nearest) {
    return nearest;
  }
  return 4 / (1 / a + 1 / b + 1 / c + 1 / d);
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
  for (int v = 0; v < half.rows; ++v) {
    const float* upper = depth[2 * v];
    const float* lower = depth[2 * v + 1];
    for (int u = 0; u < half.cols; ++u) {
      half(v, u) = merged_depth(upper[2 * u], upper[2 * u + 1], lower[2 * u], lower[2 * u + 1]);
    }
  }
  return half;
}

GradientImage central_gradient(const GrayImage& image) {
  GradientImage gradient(image.size(), cv::Vec2f(0, 0));
  for (int v = 1; v + 1 < image.rows; ++v) {
    const float* above = image[v - 1];
    const float* row = image[v];
    const float* below = image[v + 1];
    cv::Vec2f* target = gradient[v];
    for (int u = 1; u + 1 < image.cols; ++u) {
      target[u] = {0.5F * (row[u + 1] - row[u - 1]), 0.5F * (below[u] - above[u])};
    }
  }
  return gradient;
}

FramePyramid build_pyramid(const RgbdFrame& frame, const PinholeCamera& camera,
                           const PyramidOptions& options) {
  FramePyramid pyramid{frame.timestamp, {}};
  PyramidLevel level{camera, to_gray(frame.image), {}, {}, frame.depth};
  while (true) {
    level.gradient = central_gradient(level.intensity);
    pyramid.levels.push_back(level);
    const PinholeCamera half = level.camera.halved();
    if (static_cast<int>(pyramid.levels.size()) == options.levels ||
        std::min(half.width, half.height) < kMinSize) {
      return pyramid;
    }
    level = {half, halve(level.intensity), {}, {}, halve_depth(level.depth)};
  }
}

void add_edges(FramePyramid& pyramid, const EdgeOptions& options) {
  for (PyramidLevel& level : pyramid.levels) {
    level.edges = detect_edges(level.intensity, options);
  }
}

}  // namespace vo
