#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kPi = std::numbers::pi;
const cv::Point kCentre(32, 24);

/// A closed box around the camera that shines by itself.
Scene furnace(float albedo, float emission) {
  Scene scene;
  Material wall = diffuse(Vector3f::Constant(albedo));
  wall.emission.setConstant(emission);
  for (const float side : {-1.0F, 1.0F}) {
    add(scene, quad({-1, -1, side}, {2, 0, 0}, {0, 2, 0}), wall);
    add(scene, quad({-1, side, -1}, {2, 0, 0}, {0, 0, 2}), wall);
    add(scene, quad({side, -1, -1}, {0, 2, 0}, {0, 0, 2}), wall);
  }
  return scene;
}

TEST(Path, InAFurnaceEveryPixelIsTheGeometricSeries) {
  constexpr double kAlbedo = 0.6;
  for (const int bounces : {0, 1, 6}) {
    const RenderedFrame frame =
        render(furnace(static_cast<float>(kAlbedo), 0.25F),
               {.mode = RenderMode::path, .samples = 4, .ambient = 0, .bounces = bounces});
    const double expected = 0.25 * (1 - std::pow(kAlbedo, bounces + 1)) / (1 - kAlbedo);
    for (const cv::Vec3f& pixel : frame.radiance) {
      ASSERT_NEAR(pixel[1], expected, 1e-5);
    }
  }
}

TEST(Path, APlaneUnderTheOpenSkyIsTheClosedForm) {
  const Vector3d up = Vector3d(0.3, 1, 0.5).normalized();  // the default sky's axis
  Scene scene;
  Mesh mesh = square_at(0, 4);
  add(scene, mesh, diffuse({0.5F, 0.5F, 0.5F}));
  scene.instances[0].T_world_mesh =
      Eigen::Translation3d(-3 * up) * Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), up);
  const vo::SE3 looking_down(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), -up),
                             Vector3d::Zero());
  const RenderedFrame frame =
      render(scene, {.mode = RenderMode::path, .samples = 4}, wide_camera(), looking_down);
  EXPECT_NEAR(frame.radiance(kCentre)[0], 0.5, 1e-5);  // shows its base colour
}

/// A floor that a lamp above its middle lights past the edge of a screen.
Scene half_shaded_wall() {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));
  add(scene, quad({0, -4, -1}, {4, 0, 0}, {0, 8, 0}), diffuse({0, 0, 0}));
  scene.lights.push_back(point_light({0, 0, -2}, {100, 100, 100}));
  return scene;
}

TEST(Path, WithoutBouncesIsDirectLightToTheBit) {
  const Scene scene = half_shaded_wall();
  const RenderedFrame direct = render(scene, {.ambient = 0});
  const RenderedFrame path = render(scene, {.mode = RenderMode::path, .ambient = 0, .bounces = 0});
  EXPECT_EQ(cv::norm(direct.radiance, path.radiance, cv::NORM_INF), 0);
}

TEST(SoftShadow, IsHalfLitAtTheEdgeAndAsWideAsSimilarTrianglesSay) {
  constexpr float kRadius = 0.1F;  // m; 1 m behind the screen's edge, 3 m before the wall
  const Scene scene = half_shaded_wall();
  const RenderedFrame soft = render(scene, {.samples = 256, .ambient = 0, .light_radius = kRadius});
  const RenderedFrame hard = render(scene, {.samples = 16, .ambient = 0});
  const vo::PinholeCamera camera = wide_camera();
  for (int u = 16; u < 48; ++u) {
    const double x = camera.unproject(Eigen::Vector2d(u, 24), 2).x();
    const double full = 100 * 4 / std::pow(x * x + 16, 1.5) / kPi;
    const double across = std::clamp(-x / (3 * kRadius), -1.0, 1.0);  // in radii of the light
    const double share = 0.5 + (across * std::sqrt(1 - across * across) + std::asin(across)) / kPi;
    EXPECT_NEAR(soft.radiance(24, u)[0], share * full, 0.05 * full) << "column " << u;
  }
  EXPECT_GT(hard.radiance(24, 31)[0], 0);
  EXPECT_EQ(hard.radiance(24, 33)[0], 0);
}

TEST(Path, DrawsTheSameNumbersEachTimeAndOthersForAnotherSeed) {
  const Scene scene = half_shaded_wall();
  const auto renderer = make_renderer(scene, {.mode = RenderMode::path});
  Capture capture = still(wide_camera(), {});
  const cv::Mat_<cv::Vec3f> first = renderer->render(capture).radiance;
  EXPECT_EQ(cv::norm(first, renderer->render(capture).radiance, cv::NORM_INF), 0);
  capture.seed = 1;
  EXPECT_GT(cv::norm(first, renderer->render(capture).radiance, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace synth
