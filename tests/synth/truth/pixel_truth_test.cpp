#include "synth/truth/pixel_truth.h"

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

/// A wall without a material at 2 m, a tilted square in front of it, and an instance of nothing.
Scene room() {
  Scene scene;
  scene.instances.emplace_back();
  add(scene, square_at(2, 1), unlit({1, 1, 1}));
  scene.meshes.back().material = kNone;
  add(scene, quad({-0.5F, -0.5F, 1}, {1, 0, 0.5F}, {0, 1, 0}), unlit({1, 0, 0}));
  return scene;
}

TEST(PixelTruth, DepthIsTheTracersAndThePlanes) {
  const Scene scene = room();
  const PointTracer tracer(scene);
  const vo::PinholeCamera camera = wide_camera();
  const vo::DepthImage depth = depth_truth(tracer.trace(camera, {}));
  const RenderedFrame rendered = render(scene, {.samples = 1});
  EXPECT_LT(cv::norm(depth, rendered.depth, cv::NORM_INF), 1e-6) << "m";
  // On the tilted square, z = 1.25 + 0.5 x = 1.25 + 0.5 z (u - cx) / fx.
  EXPECT_NEAR(depth(24, 40), 1.25 / (1 - 0.5 * 8 / camera.fx), 1e-6);
}

TEST(PixelTruth, NormalsAreTheTrianglesInTheWorldTowardsTheCamera) {
  const Scene scene = room();
  const PointTracer tracer(scene);
  const vo::SE3 T_world_camera(Eigen::Quaterniond(0, 0, 0, 1), {0, 0, 0});  // on its head
  const PointImage points = tracer.trace(wide_camera(), T_world_camera);
  const auto normal = normal_truth(points, tracer, T_world_camera.translation());
  const cv::Vec3f tilted = cv::normalize(cv::Vec3f(0.5F, 0, -1));
  EXPECT_LT(cv::norm(normal(24, 32), tilted), 1e-6);
  EXPECT_LT(cv::norm(normal(24, 18), cv::Vec3f(0, 0, -1)), 1e-6);
  EXPECT_EQ(cv::norm(normal(0, 0)), 0) << "nothing there";
}

TEST(PixelTruth, IdsCountTheScenesElementsFromOne) {
  const Scene scene = room();
  const PointTracer tracer(scene);
  const PointImage points = tracer.trace(wide_camera(), {});
  const IdImage instance = instance_truth(points, tracer.scene());
  const IdImage material = material_truth(points, tracer.scene());
  EXPECT_EQ(instance(24, 32), 3) << "the third instance, the square";
  EXPECT_EQ(instance(24, 46), 2);
  EXPECT_EQ(instance(0, 0), 0);
  EXPECT_EQ(material(24, 32), 2);
  EXPECT_EQ(material(24, 46), 3) << "none of the two";
  EXPECT_EQ(material(0, 0), 0);
}

TEST(PixelTruth, ClassesAreThoseOfTheInstances) {
  const Scene scene = room();
  const PointTracer tracer(scene);
  const PointImage points = tracer.trace(wide_camera(), {});
  const IdImage image = class_truth(points, tracer.scene(), {9, 0, 7});
  EXPECT_EQ(image(24, 32), 7) << "the third instance, the square";
  EXPECT_EQ(image(24, 46), 0);
  EXPECT_EQ(image(0, 0), 0);
}

TEST(PixelTruth, RefusesMoreInstancesThanIdsHold) {
  Scene scene = room();
  scene.instances.resize(65536);
  const PointTracer tracer(scene);
  const PointImage points = tracer.trace(wide_camera(), {});
  EXPECT_EQ(support::error_text([&] { instance_truth(points, tracer.scene()); }),
            "ground truth: the scene has 65536 instances, expected at most 65535 for 16-bit ids");
}

}  // namespace
}  // namespace synth
