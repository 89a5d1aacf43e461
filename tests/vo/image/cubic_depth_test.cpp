#include "vo/image/cubic_depth.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace {

vo::DepthImage random_depth(cv::Size size) {
  std::mt19937 random(7);
  vo::DepthImage depth(size);
  for (float& value : depth) {
    value = random() % 5 == 0 ? 0 : 0.5F + static_cast<float>(random() % 4096) / 1000;
  }
  return depth;
}

/// OpenCV's rounding is that of the processor, so that its pixels are near and not the same.
TEST(HalveCubic, AgreesWithOpenCv) {
  for (const cv::Size size : {cv::Size(64, 48), cv::Size(61, 47), cv::Size(5, 4), cv::Size(2, 2)}) {
    const vo::DepthImage depth = random_depth(size);
    vo::DepthImage half;
    vo::halve_cubic(depth, half);
    vo::DepthImage expected;
    cv::resize(depth, expected, {size.width / 2, size.height / 2}, 0, 0, cv::INTER_CUBIC);
    ASSERT_EQ(half.size(), expected.size());
    EXPECT_LT(cv::norm(half, expected, cv::NORM_INF), 4e-6) << size;
  }
}

/// Cubic convolution reproduces polynomials of degree 1, half a pixel from the pixels.
TEST(HalveCubic, ARampStaysARamp) {
  vo::DepthImage ramp(12, 16);
  for (int v = 0; v < ramp.rows; ++v) {
    for (int u = 0; u < ramp.cols; ++u) {
      ramp(v, u) = 1 + 0.1F * static_cast<float>(u) + 0.2F * static_cast<float>(v);
    }
  }
  vo::DepthImage half;
  vo::halve_cubic(ramp, half);
  EXPECT_NEAR(half(2, 3), 1 + 0.1 * 6.5 + 0.2 * 4.5, 1e-6);
}

TEST(HalveCubic, NothingIsHalvedToNothing) {
  vo::DepthImage half(3, 3);
  vo::halve_cubic({}, half);
  EXPECT_TRUE(half.empty());
}

}  // namespace
