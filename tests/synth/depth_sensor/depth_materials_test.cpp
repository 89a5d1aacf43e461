#include "synth/depth_sensor/depth_materials.h"

#include <gtest/gtest.h>

namespace synth {
namespace {

/// Three pixels: opaque at 1 m, glass at 1 m before 2 m, a mirror at 1 m that shows 3 m; light
/// returns by the distance alone.
RenderedFrame three_pixels() {
  RenderedFrame frame;
  const cv::Vec3f facing(0, 0, -1);
  const cv::Vec3f aside(1, 0, 0);
  frame.depth = (vo::DepthImage(1, 3) << 1, 1, 1);
  frame.normal = cv::Mat_<cv::Vec3f>(1, 3, facing);
  frame.sight.first = (cv::Mat_<std::uint8_t>(1, 3) << 0, 1, 2);
  frame.sight.returned = (cv::Mat_<float>(1, 3) << 1, 0.1F, 0.2F);
  frame.sight.beyond = (vo::DepthImage(1, 3) << 1, 2, 3);
  frame.sight.beyond_normal = cv::Mat_<cv::Vec3f>(1, 3, aside);
  frame.sight.beyond_returned = (cv::Mat_<float>(1, 3) << 1, 0.25F, 1 / 9.0F);
  return frame;
}

void expect_depths(const DepthMaterials& materials, float opaque, float glass, float mirror) {
  const DepthView view = seen_by_depth_camera(three_pixels(), materials);
  EXPECT_EQ(view.depth(0, 0), opaque);
  EXPECT_EQ(view.depth(0, 1), glass);
  EXPECT_EQ(view.depth(0, 2), mirror);
}

TEST(DepthMaterials, EachKindOfSurfaceHasItsOwnSwitch) {
  using enum ClearSurface;
  expect_depths({}, 1, 1, 1);
  expect_depths({.glass = beyond}, 1, 2, 1);
  expect_depths({.glass = lost}, 1, 0, 1);
  expect_depths({.mirrors = beyond}, 1, 1, 3);
  expect_depths({.glass = beyond, .mirrors = lost}, 1, 2, 0);
}

TEST(DepthMaterials, NormalsAreThoseOfWhatIsMeasured) {
  const DepthView view = seen_by_depth_camera(
      three_pixels(), {.glass = ClearSurface::beyond, .mirrors = ClearSurface::lost});
  EXPECT_EQ(view.normal(0, 0), cv::Vec3f(0, 0, -1));
  EXPECT_EQ(view.normal(0, 1), cv::Vec3f(1, 0, 0));
  EXPECT_EQ(view.normal(0, 2), cv::Vec3f(0, 0, 0));
}

TEST(DepthMaterials, SurfacesThatReturnTooLittleHaveNoDepth) {
  using enum ClearSurface;
  expect_depths({.min_return = 0.15}, 1, 0, 1);
  expect_depths({.glass = beyond, .mirrors = beyond, .min_return = 0.15}, 1, 2, 0);
}

TEST(DepthMaterials, WithoutSightAreThoseOfTheFirstSurface) {
  RenderedFrame frame = three_pixels();
  frame.sight = {};
  const DepthView view = seen_by_depth_camera(frame, {.glass = ClearSurface::lost});
  EXPECT_EQ(cv::norm(view.depth, frame.depth, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace synth
