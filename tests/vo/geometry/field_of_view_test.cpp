#include "vo/geometry/field_of_view.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace vo {
namespace {

/// Returns the point this far off the optical axis, deg, to the right.
Eigen::Vector3d point_at(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return {2 * std::sin(angle), 0, 2 * std::cos(angle)};
}

PinholeCamera camera_of(const Distortion& lens) {
  PinholeCamera camera = PinholeCamera::from_horizontal_fov(64, 48, 50);
  camera.distortion = lens;
  camera.validate();
  return camera;
}

TEST(FieldOfView, OfAPerfectLensEndsAtTheBorderOfTheImage) {
  const PinholeCamera camera = camera_of({});
  EXPECT_TRUE(is_in_view(camera, point_at(24.9)));
  EXPECT_FALSE(is_in_view(camera, point_at(25.1)));
  EXPECT_FALSE(is_in_view(camera, -point_at(10))) << "behind";
}

/// r (1 - 0.3 r^2) reaches the right border, tan 25 deg, at r = 0.504, is greatest at r = 1.054 and
/// falls to the left border by r = 2.025, 63.7 deg off the axis.
TEST(FieldOfView, EndsOnceWhereALensFoldsBack) {
  const PinholeCamera camera = camera_of({.k1 = -0.3});
  const double border_deg = [] {
    double r = 0.5;
    for (int i = 0; i < 20; ++i) {
      r -= (r * (1 - 0.3 * r * r) - std::tan(25 * std::numbers::pi / 180)) / (1 - 0.9 * r * r);
    }
    return std::atan(r) * 180 / std::numbers::pi;
  }();
  for (double angle = 0.5; angle < 89; angle += 0.5) {
    EXPECT_EQ(is_in_view(camera, point_at(angle)), angle < border_deg) << angle << " deg";
  }
  EXPECT_TRUE(camera.contains(camera.project(point_at(61)))) << "the polynomial alone";
}

TEST(FieldOfView, OfAFisheyeEndsWhereItImagesNothing) {
  PinholeCamera camera = camera_of({.model = DistortionModel::kannala_brandt});
  camera.fx = camera.fy = 20;
  EXPECT_TRUE(is_in_view(camera, point_at(84.9)));
  EXPECT_TRUE(camera.contains(camera.project(point_at(85.1))));
  EXPECT_FALSE(is_in_view(camera, point_at(85.1)));
}

}  // namespace
}  // namespace vo
