#include "vo/geometry/lens.h"

#include <gtest/gtest.h>

#include "vo/dataset/camera_file.h"

namespace {

using vo::Distortion;

Distortion fisheye_lens() {
  return {.k1 = -0.013,
          .k2 = 0.021,
          .k3 = -0.012,
          .k4 = 0.0021,
          .model = vo::DistortionModel::kannala_brandt};
}

/// A lens with a denominator, as the Azure Kinect's SDK gives them.
Distortion rational_lens() {
  return {0.47516, -2.5563, 7.27e-4, -2.9e-4, 1.45127, 0.35689, -2.38113, 1.38187};
}

TEST(Distortion, HasTheDerivativeOfItsDifferences) {
  constexpr double kStep = 1e-6;
  for (const Distortion& lens :
       {vo::load_camera("tum-fr1").pinhole.distortion, fisheye_lens(), rational_lens()}) {
    for (const auto& [x, y] :
         {std::pair{0.3, -0.2}, std::pair{-0.5, 0.4}, std::pair{0.0, 0.0}, std::pair{1e-3, 0.0}}) {
      const auto point = vo::distort(lens, x, y);
      const auto right = vo::distort(lens, x + kStep, y);
      const auto left = vo::distort(lens, x - kStep, y);
      const auto below = vo::distort(lens, x, y + kStep);
      const auto above = vo::distort(lens, x, y - kStep);
      EXPECT_NEAR(point.dx_dx, (right.x - left.x) / (2 * kStep), 1e-8);
      EXPECT_NEAR(point.dx_dy, (right.y - left.y) / (2 * kStep), 1e-8);
      EXPECT_NEAR(point.dx_dy, (below.x - above.x) / (2 * kStep), 1e-8) << "symmetric";
      EXPECT_NEAR(point.dy_dy, (below.y - above.y) / (2 * kStep), 1e-8);
    }
  }
}

TEST(Distortion, WithADenominatorIsTakenBack) {
  for (double x = -0.6; x <= 0.6; x += 0.1) {
    for (double y = -0.5; y <= 0.5; y += 0.1) {
      const auto imaged = vo::distort(rational_lens(), x, y);
      EXPECT_LT((rational_lens().remove({imaged.x, imaged.y}) - Eigen::Vector2d(x, y)).norm(),
                1e-12);
    }
  }
}

TEST(Distortion, WithADenominatorOfOneIsTheLensWithoutOne) {
  const Distortion plain = vo::load_camera("tum-fr1").pinhole.distortion;
  Distortion rational = plain;
  rational.k6 = 1e-300;
  EXPECT_TRUE(rational.is_rational());
  for (const auto& [x, y] : {std::pair{0.3, -0.2}, std::pair{-0.5, 0.4}}) {
    const auto a = vo::distort(plain, x, y);
    const auto b = vo::distort(rational, x, y);
    EXPECT_NEAR(a.x, b.x, 1e-15);
    EXPECT_NEAR(a.y, b.y, 1e-15);
    EXPECT_NEAR(a.dx_dx, b.dx_dx, 1e-14);
    EXPECT_NEAR(a.dx_dy, b.dx_dy, 1e-14);
  }
}

TEST(Distortion, OfAFisheyeHasADerivativeFarOut) {
  constexpr double kStep = 1e-5;
  const double x = 5;  // 79 deg off the axis
  const auto point = vo::distort(fisheye_lens(), x, 1.0);
  const auto right = vo::distort(fisheye_lens(), x + kStep, 1.0);
  const auto left = vo::distort(fisheye_lens(), x - kStep, 1.0);
  EXPECT_NEAR(point.dx_dx, (right.x - left.x) / (2 * kStep), 1e-9);
  EXPECT_NEAR(point.dx_dy, (right.y - left.y) / (2 * kStep), 1e-9);
}

TEST(Distortion, IsTheSameInSinglePrecision) {
  for (const auto& [x, y] : {std::pair{0.3, -0.2}, std::pair{-2.5, 1.4}, std::pair{1e-3, 2e-4}}) {
    const auto exact = vo::distort(fisheye_lens(), x, y);
    const auto single = vo::distort(fisheye_lens(), static_cast<float>(x), static_cast<float>(y));
    EXPECT_NEAR(single.x, exact.x, 3e-7);
    EXPECT_NEAR(single.y, exact.y, 3e-7);
    EXPECT_NEAR(single.dx_dx, exact.dx_dx, 1e-6);
    EXPECT_NEAR(single.dx_dy, exact.dx_dy, 1e-6);
  }
}

}  // namespace
