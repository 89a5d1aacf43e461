#include "vo/image/usable_pixels.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "vo/core/hash.h"

namespace {

double chance(std::uint64_t purpose, int index) {
  return vo::random_uniform({purpose, static_cast<std::uint64_t>(index)});
}

/// Surfaces 0.5 m apart with noise, holes, and what no sensor should give.
vo::DepthImage patchy_depth(cv::Size size) {
  vo::DepthImage depth(size);
  for (int i = 0; i < size.area(); ++i) {
    const cv::Point at(i % size.width, i / size.width);
    const double surface = 0.5 * (1 + at.x / 9 % 4 + at.y / 7 % 3);
    const double odd = chance(1, i);
    depth(at) = odd < 0.05    ? 0.0F
                : odd < 0.06  ? std::numeric_limits<float>::quiet_NaN()
                : odd < 0.065 ? std::numeric_limits<float>::infinity()
                : odd < 0.07  ? -1.0F
                              : static_cast<float>(surface + 0.01 * chance(2, i));
  }
  return depth;
}

vo::EdgeMask half_of_all(cv::Size size) {
  vo::EdgeMask mask(size);
  for (int i = 0; i < size.area(); ++i) {
    mask(i / size.width, i % size.width) = chance(3, i) < 0.5 ? uchar{255} : uchar{0};
  }
  return mask;
}

/// By the definition, pixel by pixel.
bool is_usable(const vo::DepthImage& depth, cv::Point pixel, const vo::UsableDepth& usable) {
  const float own = depth(pixel);
  if (!(own >= usable.nearest) || !(own <= usable.farthest)) {
    return false;
  }
  const int r = usable.step_radius;
  float nearest = own;
  float farthest = own;
  for (int v = std::max(0, pixel.y - r); v <= std::min(depth.rows - 1, pixel.y + r); ++v) {
    for (int u = std::max(0, pixel.x - r); u <= std::min(depth.cols - 1, pixel.x + r); ++u) {
      if (depth(v, u) > 0) {
        nearest = std::min(nearest, depth(v, u));
        farthest = std::max(farthest, depth(v, u));
      }
    }
  }
  return farthest <= nearest * usable.step_ratio;
}

TEST(UsablePixels, AreThoseInRangeAndBesideNoStep) {
  for (const cv::Size size : {cv::Size(70, 22), {64, 3}, {5, 9}, {1, 1}}) {
    const vo::DepthImage depth = patchy_depth(size);
    const vo::EdgeMask mask = half_of_all(size);
    for (const int radius : {0, 1, 2}) {
      const vo::UsableDepth usable{0.6F, 2.2F, radius, 1.1F};
      std::vector<cv::Point> expected;
      for (int i = 0; i < size.area(); ++i) {
        const cv::Point pixel(i % size.width, i / size.width);
        if (mask(pixel) != 0 && is_usable(depth, pixel, usable)) {
          expected.push_back(pixel);
        }
      }
      std::vector<cv::Point> found(3);
      vo::find_usable_pixels(depth, mask, usable, found);
      EXPECT_EQ(found, expected) << size << ' ' << radius;
    }
  }
}

}  // namespace
