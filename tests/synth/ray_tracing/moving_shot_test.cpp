#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene_motion.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;

const Vector3d kVelocity(1.5, 0.1, -0.2);  // m/s, of the things or, the other way, of the camera
constexpr double kDuration = 4;            // s, of the animation
constexpr double kNow = 2;                 // s

/// A square before a wall and its shadow on it, by a light from infinitely far.
Scene square_before_wall() {
  Scene scene;
  add(scene, square_at(2, 0.7F), diffuse({1, 1, 1}));
  add(scene, square_at(2.5, 16), diffuse({0.4F, 0.3F, 0.2F}));
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = Vector3d(0.3, 0.2, 1).normalized();
  scene.lights.push_back(sun);
  return scene;
}

/// Its things, of the given number, move with the velocity and are where they were built at kNow.
Scene moving(Scene scene, std::size_t things) {
  scene.motion.nodes.resize(3);
  scene.motion.instance_nodes = {0, things > 1 ? 0 : 1};
  scene.motion.light_nodes = {2};
  scene.motion.nodes[2].T_parent_node =
      Eigen::Quaterniond::FromTwoVectors(-Vector3d::UnitZ(), scene.lights[0].direction);
  AnimationCurve curve{.width = 3, .times = {0, kDuration}};
  for (const double time : {-kNow, kDuration - kNow}) {
    for (const double value : kVelocity) {
      curve.values.push_back(static_cast<float>(time * value));
    }
  }
  scene.motion.animations = {
      {.duration = kDuration,
       .channels = {{.property = AnimatedProperty::translation, .curve = curve}}}};
  return scene;
}

vo::SE3 against(double time) {
  return {Eigen::Quaterniond::Identity(), -time * kVelocity};
}

RenderedFrame of_moving_things(const Shutter& shutter, RenderMode mode = RenderMode::direct) {
  const Scene scene = moving(square_before_wall(), 2);
  Capture capture = still(wide_camera(), {});
  capture.shutter = shutter;
  capture.scene_time = kNow;
  const SceneDuring during = scene_during(scene, kNow, kNow - 0.3, kNow + 0.3);
  return make_renderer(during, {.mode = mode, .samples = 16})->render(capture);
}

RenderedFrame of_moving_camera(const Shutter& shutter, RenderMode mode = RenderMode::direct) {
  const Scene scene = square_before_wall();
  const Capture capture{.camera = wide_camera(), .motion = against, .shutter = shutter};
  return make_renderer(scene, {.mode = mode, .samples = 16})->render(capture);
}

/// The share of pixels whose colour differs by more than a hundredth: rays along an edge may meet
/// or miss it by rounding.
double share_that_differs(const cv::Mat_<cv::Vec3f>& a, const cv::Mat_<cv::Vec3f>& b) {
  int differing = 0;
  for (int v = 0; v < a.rows; ++v) {
    for (int u = 0; u < a.cols; ++u) {
      differing += cv::norm(a(v, u) - b(v, u)) > 0.01 ? 1 : 0;
    }
  }
  return differing / static_cast<double>(a.total());
}

TEST(MovingShot, OfAnExposureIsThatOfACameraThatMovesTheOtherWay) {
  const Shutter shutter{.exposure_time = 0.2, .readout_time = 0.3};
  for (const RenderMode mode : {RenderMode::direct, RenderMode::path, RenderMode::unlit}) {
    const RenderedFrame things = of_moving_things(shutter, mode);
    const RenderedFrame camera = of_moving_camera(shutter, mode);
    EXPECT_LT(share_that_differs(things.radiance, camera.radiance), 0.002);
    EXPECT_GT(share_that_differs(things.radiance, of_moving_camera({}, mode).radiance), 0.05);
  }
}

TEST(MovingShot, OfARollingShutterHasTheDepthOfACameraThatMovesTheOtherWay) {
  const Shutter shutter{.readout_time = 0.4};
  EXPECT_LT(
      cv::norm(of_moving_things(shutter).depth, of_moving_camera(shutter).depth, cv::NORM_INF),
      1e-6);
}

TEST(MovingShot, OfARollingShutterHasPointsThatAreWhereTheirRowsSeeThem) {
  const Scene scene = moving(square_before_wall(), 1);
  const vo::CameraModel camera = wide_camera();
  Capture capture = still(camera, {});
  capture.shutter = {.readout_time = 0.4};
  capture.scene_time = kNow;
  capture.channels.points = true;
  const SceneDuring during = scene_during(scene, kNow, kNow - 0.3, kNow + 0.3);
  const auto renderer = make_renderer(during, {});
  const RenderedFrame frame = renderer->render(capture);
  double farthest_at_stamp = 0;  // px
  for (int v = 0; v < camera.height(); ++v) {
    const double time = kNow + capture.shutter.row_time(v, camera.height());
    for (int u = 0; u < camera.width(); ++u) {
      const TrianglePoint& point = frame.points.at(u, v);
      ASSERT_TRUE(point.exists());
      const Eigen::Vector2d pixel(u, v);
      EXPECT_LT((camera.project(renderer->position(point, time)) - pixel).norm(), 1e-3);
      const double apart = (camera.project(renderer->position(point, kNow)) - pixel).norm();
      farthest_at_stamp = std::max(farthest_at_stamp, apart);
    }
  }
  EXPECT_GT(farthest_at_stamp, 1);
}

TEST(MovingShot, LeavesWhatRestsWhereItIs) {
  const Scene scene = moving(square_before_wall(), 1);
  Capture capture = still(wide_camera(), {});
  capture.shutter = {.readout_time = 0.4};
  capture.scene_time = kNow;
  const SceneDuring during = scene_during(scene, kNow, kNow - 0.3, kNow + 0.3);
  const RenderedFrame frame = make_renderer(during, {})->render(capture);
  EXPECT_FLOAT_EQ(frame.depth(0, 0), 2.5F);
  const double time = capture.shutter.row_time(20, wide_camera().height);
  EXPECT_NEAR(frame.depth(20, 32), 2 + time * kVelocity.z(), 1e-6);
}

TEST(MovingShot, OfAnInstantIsThatOfTheSceneThen) {
  const Scene scene = moving(square_before_wall(), 2);
  const SceneDuring during = scene_during(scene, kNow, kNow - 0.3, kNow + 0.3);
  Capture capture = still(wide_camera(), {});
  capture.scene_time = kNow + 0.1;
  const Scene then = scene_at(scene, capture.scene_time);
  const RenderedFrame expected = make_renderer(then, {})->render(wide_camera(), {});
  const RenderedFrame frame = make_renderer(during, {})->render(capture);
  EXPECT_LT(cv::norm(frame.depth, expected.depth, cv::NORM_INF), 1e-6);
  EXPECT_LT(share_that_differs(frame.radiance, expected.radiance), 0.002);
}

TEST(SceneDuring, RestsWhereItLastsNoTime) {
  EXPECT_TRUE(scene_during(moving(square_before_wall(), 2), 1, 1, 1).moments.empty());
}

}  // namespace
}  // namespace synth
