#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/balls.h"
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

/// Returns the mean of an image's green channel.
double mean_green(const cv::Mat_<cv::Vec3f>& image) {
  return cv::mean(image)[1];
}

TEST(Path, AFurnaceIsTheGeometricSeries) {
  constexpr double kAlbedo = 0.6;
  for (const int bounces : {0, 1, 6}) {
    const RenderedFrame frame =
        render(furnace(static_cast<float>(kAlbedo), 0.25F),
               {.mode = RenderMode::path, .samples = 64, .ambient = 0, .bounces = bounces});
    const double expected = 0.25 * (1 - std::pow(kAlbedo, bounces + 1)) / (1 - kAlbedo);
    EXPECT_NEAR(mean_green(frame.radiance), expected, 1e-3 * expected);
  }
}

/// A wall 2 m before the camera and a lamp 1 m behind it; no other light, also no sky.
Scene wall_before_lamp(float half_width, const Material& wall) {
  Scene scene;
  add(scene, square_at(2, 4), wall);
  Material lamp = diffuse({0, 0, 0});
  lamp.emission.setConstant(4);
  add(scene, square_at(-1, half_width), lamp);
  scene.lights.push_back(point_light({0, 0, 0}, {0, 0, 0}));
  return scene;
}

/// Returns the share of a half space's cosine-weighted directions that a rectangle fills which
/// faces the point, has a corner straight above it and the other corner at (a, b), in units of its
/// distance.
double share_of_view(double a, double b) {
  const double x = std::sqrt(1 + a * a);
  const double y = std::sqrt(1 + b * b);
  return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * kPi);
}

TEST(Path, ALampsLightIsTheClosedFormWhateverItsSize) {
  for (const float half_width : {0.01F, 0.3F, 3.0F, 30.0F}) {
    const RenderedFrame frame =
        render(wall_before_lamp(half_width, diffuse({0.5F, 0.5F, 0.5F})),
               {.mode = RenderMode::path, .samples = 256, .ambient = 0, .bounces = 1});
    const double expected = 0.5 * 4 * 4 * share_of_view(half_width / 3.0, half_width / 3.0);
    const cv::Rect middle(kCentre - cv::Point(1, 1), cv::Size(3, 3));
    EXPECT_NEAR(mean_green(frame.radiance(middle)), expected, 0.01 * expected) << half_width;
  }
}

/// Returns the light of a lamp 0.6 m wide and high, 1 cm before a wall, on the wall at a distance,
/// m, from the foot of the middle of its edge, in lengths of the lamp's radiance times the albedo.
double light_beside_lamp(double distance) {
  constexpr double kGap = 0.01;
  const double half_height = 0.3 / kGap;
  return 2 * (share_of_view((distance + 0.6) / kGap, half_height) -
              share_of_view(distance / kGap, half_height));
}

TEST(Path, ALampCloseToAWallLightsItByTheClosedForm) {
  constexpr double kPixel = 0.005;  // m on the wall
  Scene scene;
  add(scene, square_at(2, 1), diffuse({0.5F, 0.5F, 0.5F}));
  Material lamp = diffuse({0, 0, 0});
  lamp.emission.setConstant(4);
  add(scene, quad({-0.61F, -0.3F, 1.99F}, {0.6F, 0, 0}, {0, 0.6F, 0}), lamp);
  scene.lights.push_back(point_light({0, 0, 0}, {0, 0, 0}));
  vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(9, 9, 1);
  camera.fx = camera.fy = 2 / kPixel;
  const RenderedFrame frame = render(
      scene, {.mode = RenderMode::path, .samples = 2500, .ambient = 0, .bounces = 1}, camera);
  for (int u = 4; u < camera.width; ++u) {
    double expected = 0;
    for (const double offset : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
      expected += 0.5 * 4 * light_beside_lamp(0.01 + (u - camera.cx + offset) * kPixel) / 5;
    }
    EXPECT_NEAR(mean_green(frame.radiance.col(u)), expected, 0.015 * expected) << "column " << u;
  }
}

TEST(Path, AMirrorShowsTheLampAsBrightAsItIs) {
  Material mirror = diffuse({1, 1, 1});
  mirror.metallic = 1;
  mirror.roughness = 0.05F;
  const RenderedFrame frame =
      render(wall_before_lamp(1, mirror),
             {.mode = RenderMode::path, .samples = 256, .ambient = 0, .bounces = 1});
  EXPECT_NEAR(frame.radiance(kCentre)[1], 4, 0.02);
}

TEST(Path, AMaskedLampShinesByItsShare) {
  Scene half = wall_before_lamp(1, diffuse({1, 1, 1}));
  half.materials[1].alpha_mode = AlphaMode::blend;
  half.materials[1].base_color.w() = 0.25F;
  const RenderOptions options{.mode = RenderMode::path, .samples = 256, .ambient = 0, .bounces = 1};
  const double whole =
      mean_green(render(wall_before_lamp(1, diffuse({1, 1, 1})), options).radiance);
  EXPECT_NEAR(mean_green(render(half, options).radiance), whole / 4, 0.01 * whole);
}

TEST(Environment, AWhiteBallCannotBeSeenBeforeAWhiteSky) {
  const RenderedFrame frame =
      render(ball_in_white(diffuse({1, 1, 1})),
             {.mode = RenderMode::path, .samples = 256, .ambient = 0, .bounces = 8});
  EXPECT_EQ(frame.radiance(0, 0), cv::Vec3f(1, 1, 1));
  const cv::Rect inside(kCentre - cv::Point(5, 5), cv::Size(11, 11));
  EXPECT_NEAR(mean_green(frame.radiance(inside)), 1, 1e-3);
}

TEST(Environment, InDirectLightABallShowsItsBaseColour) {
  const RenderedFrame frame = render(ball_in_white(diffuse({0.25F, 0.5F, 1})), {});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(frame.radiance(kCentre)[i], 0.25 * std::pow(2, i), 3e-3);
  }
}

TEST(Environment, OfHalfASkyHalfArrives) {
  Scene scene;
  add(scene, square_at(2, 4), diffuse({1, 1, 1}));  // faces +z, behind the camera
  scene.environment.radiance.create(64, 128);
  scene.environment.radiance = cv::Vec3f(0, 0, 0);
  scene.environment.radiance.rowRange(0, 32) = cv::Vec3f(1, 1, 1);
  const RenderedFrame frame =
      render(scene, {.mode = RenderMode::path, .samples = 1024, .ambient = 0, .bounces = 1});
  EXPECT_NEAR(frame.radiance(kCentre)[1], 0.5, 0.005);
}

TEST(Path, NoiseFallsAtLeastAsTheRootOfTheSamples) {
  const auto noise = [](int samples) {
    const RenderedFrame frame =
        render(furnace(0.6F, 0.25F),
               {.mode = RenderMode::path, .samples = samples, .ambient = 0, .bounces = 3});
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(frame.radiance, mean, deviation);
    return deviation[1];
  };
  const double of_few = noise(16);
  EXPECT_GT(of_few, 1e-4);
  EXPECT_LT(noise(256), of_few / 3.8);
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
