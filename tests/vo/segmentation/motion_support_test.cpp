#include "vo/segmentation/motion_support.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;
using vo::SE3;
using vo::ViewTiles;

constexpr double kDepth = 2;                         // m
constexpr vo::DepthNoise kNoise{.constant = 0.005};  // m

/// A wall before the camera.
vo::PyramidLevel wall() {
  const vo::PinholeCamera camera = small_camera();
  return {camera,
          vo::camera_levels(camera, {.levels = 1}).front().rays,
          {},
          {},
          vo::DepthImage(camera.height, camera.width, static_cast<float>(kDepth))};
}

/// Returns the support of the wall where the camera is taken to have moved so far towards it, m,
/// and has not.
double support_after(double towards_wall) {
  const vo::PyramidLevel level = wall();
  const vo::SurfacePoints surface = vo::surface_points(level);
  const SE3 T_cur_ref(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0, 0, -towards_wall));
  return vo::surface_support({surface, level, T_cur_ref}, kNoise);
}

/// Returns the logarithm of Student's t density of 5 degrees of freedom but for its constant.
double log_t(double x, double sigma) {
  return std::log(std::pow(1 + x * x / (5 * sigma * sigma), -3.0) / sigma);
}

TEST(MotionSupport, CountsTilesThatAgreeByTheirAreas) {
  vo::TileEvidence evidence{};
  ViewTiles::Values depths{};
  evidence[0] = 1;
  depths[0] = 2;
  evidence[1] = -2;
  depths[1] = 5;
  evidence[2] = 100;
  depths[2] = 1;
  evidence[3] = 1;
  EXPECT_DOUBLE_EQ(vo::intensity_support(evidence, depths),
                   4 + static_cast<double>(vo::kMostEvidenceOfFrame));
}

TEST(MotionSupport, OfSurfacesIsTheLogLikelihoodRatioOfTheirDistances) {
  const auto share_with_points = static_cast<double>(vo::surface_points(wall()).size() *
                                                     vo::kSurfaceSpacing * vo::kSurfaceSpacing) /
                                 static_cast<double>(wall().depth.total());
  const double sigma = std::sqrt(2.0) * kNoise.constant;
  for (const double d : {0.0, 0.005, 0.01}) {
    const double z = kDepth - d;
    const double tile = z * z * (log_t(d, sigma) - log_t(d, 0.04 * z));
    EXPECT_NEAR(support_after(d), share_with_points * ViewTiles::kCount * tile,
                1e-3 * support_after(0))
        << d;
  }
}

/// Beyond some distance a surface is more likely to have moved, and whatever moves says nothing.
TEST(MotionSupport, OfSurfacesThatMovedIsNone) {
  EXPECT_GT(support_after(0), 0);
  EXPECT_EQ(support_after(0.06), 0);
  EXPECT_EQ(support_after(0.5), 0) << "seen as another surface";
}

TEST(MotionSupport, IsClearlyBetterByIntensitiesOrByAll) {
  const vo::MotionSupport other{100, 100};
  EXPECT_FALSE(vo::is_clearly_better(other, other));
  EXPECT_FALSE(vo::is_clearly_better({102, 110}, other));
  EXPECT_TRUE(vo::is_clearly_better({104, 50}, other));
  EXPECT_TRUE(vo::is_clearly_better({80, 141}, other));
}

}  // namespace
