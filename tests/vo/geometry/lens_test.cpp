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

TEST(Distortion, HasTheDerivativeOfItsDifferences) {
  constexpr double kStep = 1e-6;
  for (const Distortion& lens : {vo::load_camera("tum-fr1").pinhole.distortion, fisheye_lens()}) {
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
