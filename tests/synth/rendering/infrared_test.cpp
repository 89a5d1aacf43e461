#include "synth/rendering/infrared.h"

#include <gtest/gtest.h>

namespace synth {
namespace {

/// A field of view of 2 atan(0.8) by 2 atan(0.6), and a picture of four by two pixels.
Projector example() {
  return {.half_extent = {0.8, 0.6},
          .pattern = (cv::Mat_<float>(2, 4) << 0, 1, 0.5F, 0.25F, 0.75F, 0.1F, 0.2F, 1)};
}

/// Returns the direction through a pixel of the picture.
Eigen::Vector3d through(double u, double v) {
  return {0.8 * ((u + 0.5) / 2 - 1), 0.6 * ((v + 0.5) - 1), 1};
}

TEST(Pattern, HasItsValuesThroughTheCentresOfItsPixels) {
  const Projector projector = example();
  for (int v = 0; v < 2; ++v) {
    for (int u = 0; u < 4; ++u) {
      EXPECT_NEAR(pattern_along(projector, 3.7 * through(u, v)), projector.pattern(v, u), 1e-6);
    }
  }
}

TEST(Pattern, IsBilinearBetweenTheCentres) {
  EXPECT_NEAR(pattern_along(example(), through(1.25, 0)), 0.75 * 1 + 0.25 * 0.5, 1e-6);
  EXPECT_NEAR(pattern_along(example(), through(2, 0.5)), (0.5 + 0.2) / 2, 1e-6);
  EXPECT_NEAR(pattern_along(example(), through(0.5, 0.5)), (0 + 1 + 0.75 + 0.1) / 4, 1e-6);
}

TEST(Pattern, EndsAtTheFieldOfViewUpToWhichItsBorderIsConstant) {
  EXPECT_NEAR(pattern_along(example(), {0.7999, 0.5999, 1}), 1, 1e-6);
  EXPECT_NEAR(pattern_along(example(), {-0.7999, 0.5999, 1}), 0.75, 1e-6);
  EXPECT_EQ(pattern_along(example(), {0.8001, 0.5999, 1}), 0);
  EXPECT_EQ(pattern_along(example(), {0.7999, 0.6001, 1}), 0);
  EXPECT_EQ(pattern_along(example(), -through(1, 0)), 0);
  EXPECT_EQ(pattern_along(example(), {1, 0, 0}), 0);
}

TEST(Pattern, OfOnePixelFillsTheFieldOfView) {
  Projector projector = example();
  projector.pattern = cv::Mat_<float>(1, 1, 0.5F);
  EXPECT_EQ(pattern_along(projector, {-0.7, 0.3, 1}), 0.5F);
  EXPECT_EQ(pattern_along(projector, {-0.81, 0.3, 1}), 0);
}

TEST(Grey, IsTheMeanOfTheColorsInAllChannels) {
  const cv::Mat_<cv::Vec3f> image(1, 1, cv::Vec3f(0.3F, 0.6F, 1.8F));
  EXPECT_NEAR(grey_of(image)(0)[0], 0.9F, 1e-6);
  EXPECT_EQ(grey_of(image)(0)[1], grey_of(image)(0)[0]);
  EXPECT_EQ(grey_of(image)(0)[2], grey_of(image)(0)[0]);
  EXPECT_NEAR(grey_of(image, 0.5)(0)[1], 0.45F, 1e-6);
}

}  // namespace
}  // namespace synth
