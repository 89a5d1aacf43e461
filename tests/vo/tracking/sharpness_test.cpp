#include "vo/tracking/sharpness.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace {

using vo::SE3;

constexpr double kPlaneDepth = 2;  // m

/// A wall across the optical axis, patterned on the left and nearly plain on the right.
vo::FramePyramid wall(int shift_px, double blur_px = 0, double gain = 1) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(320, 240, 60);
  vo::ByteImage image(camera.height, camera.width);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const int x = u + shift_px;
      const double contrast = x < 160 ? 1 : 0.2;
      const double waves = std::sin(0.3 * x + 0.05 * v) + std::sin(0.27 * v - 0.06 * x);
      image(v, u) = cv::saturate_cast<uchar>(gain * (100 + 80 * contrast * std::tanh(8 * waves)));
    }
  }
  if (blur_px > 0) {
    cv::GaussianBlur(image, image, {}, blur_px);
  }
  const vo::DepthImage depth(image.size(), static_cast<float>(kPlaneDepth));
  vo::FramePyramid pyramid = vo::build_pyramid({0, image, depth}, camera, {.levels = 1});
  vo::add_edges(pyramid, vo::EdgeOptions{});
  return pyramid;
}

double relative(const vo::FramePyramid& reference, const vo::FramePyramid& current, int shift_px) {
  const vo::EdgePoints points = vo::edge_points(reference, reference, {});
  const vo::EdgePoints current_points = vo::edge_points(current, current, {});
  const SE3 T_cur_ref(Eigen::Quaterniond::Identity(),
                      {-shift_px * kPlaneDepth / reference.levels.front().camera.fx, 0, 0});
  return vo::relative_sharpness({points.levels.front(), reference.levels.front()},
                                {current_points.levels.front(), current.levels.front()}, T_cur_ref);
}

TEST(RelativeSharpness, OfAnImageBesideItselfIsOne) {
  EXPECT_NEAR(relative(wall(0), wall(0), 0), 1, 1e-6);
}

TEST(RelativeSharpness, DoesNotGoByWhatIsInView) {
  EXPECT_NEAR(relative(wall(0), wall(120), 120), 1, 0.03) << "gradients are half as strong there";
}

TEST(RelativeSharpness, DoesNotGoByTheExposure) {
  EXPECT_NEAR(relative(wall(0), wall(20, 0, 0.5), 20), 1, 0.02) << "rounded to 8 bit";
}

TEST(RelativeSharpness, FallsWithBlurAndRisesWithoutIt) {
  const double blurred = relative(wall(0), wall(30, 3), 30);
  EXPECT_LT(blurred, 0.75);
  EXPECT_NEAR(relative(wall(0, 3), wall(30), 30) * blurred, 1, 0.02);
  EXPECT_GT(relative(wall(0, 3), wall(30, 2), 30), 1.05);
}

TEST(RelativeSharpness, OfImagesWithNothingInCommonIsOne) {
  EXPECT_EQ(relative(wall(0), wall(400), 400), 1);
}

}  // namespace
