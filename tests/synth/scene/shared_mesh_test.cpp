#include "synth/scene/shared_mesh.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/ray_tracing/embree_scene_probe.h"
#include "synth/ray_tracing/point_tracer.h"
#include "synth/ray_tracing/surface_tracer.h"
#include "synth/scene/scene_motion.h"
#include "synth/truth/motion_truth.h"
#include "synth/truth/pixel_truth.h"
#include "tests/support/copied_meshes.h"

namespace synth {
namespace {

/// All but the wall turn about the optical axis and come nearer for four seconds.
Scene moving(Scene scene) {
  MotionNode turning;
  scene.motion.nodes = {{}, turning};
  scene.motion.instance_nodes = {0};
  for (std::size_t i = 1; i < scene.instances.size(); ++i) {
    scene.motion.nodes.push_back({.parent = 1, .T_parent_node = scene.instances[i].T_world_mesh});
    scene.motion.instance_nodes.push_back(static_cast<int>(scene.motion.nodes.size()) - 1);
  }
  scene.motion.light_nodes = {static_cast<int>(scene.motion.nodes.size())};
  scene.motion.nodes.push_back(
      {.T_parent_node = Eigen::Affine3d(Eigen::Translation3d(scene.lights[0].position))});
  const AnimationCurve turn{
      .width = 4, .times = {0, 4}, .values = {0, 0, 0, 1, 0, 0, 1, 0}, .holds_quaternions = true};
  const AnimationCurve approach{.width = 3, .times = {0, 4}, .values = {0, 0, 0, 0.2F, 0, -1}};
  scene.motion.animations = {
      {.duration = 4,
       .channels = {{.node = 1, .property = AnimatedProperty::rotation, .curve = turn},
                    {.node = 1, .property = AnimatedProperty::translation, .curve = approach}}}};
  return scene;
}

TEST(SharedMesh, IsOneOfManyTriangles) {
  EXPECT_EQ(flatten(apart(copies())).shared_meshes.size(), 0U);
  Scene scene = copies();
  const WorldGeometry world = flatten(scene);
  ASSERT_EQ(world.shared_meshes.size(), 2U);
  EXPECT_EQ(world.shared_meshes[0].mesh, &scene.meshes[1]);
  scene.instances.resize(1 + kCopies);  // half of them
  EXPECT_EQ(flatten(scene).shared_meshes.size(), 0U);
}

TEST(SharedMesh, IsNotForWhatIsShearedFlatOrShortLived) {
  Scene scene = copies();
  scene.instances[3].T_world_mesh.linear().col(2).setZero();
  const std::vector<bool> sharing = sharing_instances(scene);
  EXPECT_FALSE(sharing[0]);
  EXPECT_FALSE(sharing[1 + 7]);
  EXPECT_FALSE(sharing[3]);
  EXPECT_EQ(std::count(sharing.begin(), sharing.end(), true), 2 * kCopies - 2);
  Scene mirrored = scene;
  mirrored.instances[5].T_world_mesh.linear() *= -1;  // goes through a point on its way
  EXPECT_FALSE(sharing_instances(scene, {scene, mirrored})[5]);
  EXPECT_TRUE(sharing_instances(scene, {scene, mirrored})[6]);
}

TEST(SharedMesh, PlacesVerticesWhereAMeshOfItsOwnHasThem) {
  const Scene scene = copies();
  const Scene separate = apart(scene);
  const WorldGeometry shared = flatten(scene);
  const WorldGeometry own = flatten(separate);
  EXPECT_EQ(shared.origin, own.origin);
  for (std::size_t i = 0; i < own.meshes.size(); ++i) {
    for (const int vertex : {0, 1, 3}) {
      EXPECT_EQ(shared.meshes[i].position(vertex), own.meshes[i].positions[vertex]);
    }
  }
  EXPECT_EQ(shared.meshes[2].normal(700), own.meshes[2].normals[700]);
}

TEST(SharedMesh, IsSeenAsMeshesOfTheirOwnAre) {
  const Scene scene = copies();
  const Scene separate = apart(scene);
  const Capture capture = all_of(still(camera(), {}));
  for (const RenderMode mode : {RenderMode::unlit, RenderMode::direct, RenderMode::path}) {
    const RenderOptions options{.mode = mode, .samples = 4, .bounces = 2};
    const RenderedFrame frame = make_renderer(scene, options)->render(capture);
    const RenderedFrame expected = make_renderer(separate, options)->render(capture);
    if (mode != RenderMode::path) {  // whose random turns multiply roundings
      expect_same(frame, expected);
    }
    EXPECT_NEAR(cv::mean(frame.radiance)[0], cv::mean(expected.radiance)[0], 1e-3);
  }
}

TEST(SharedMesh, MovesAsMeshesOfTheirOwnDo) {
  const Scene scene = moving(copies());
  const Scene separate = moving(apart(copies()));
  Capture capture = all_of(still(camera(), {}));
  capture.shutter = {.exposure_time = 0.1, .readout_time = 0.2};
  capture.scene_time = 2;
  const SceneDuring during = scene_during(scene, 2, 1.7, 2.3);
  const SceneDuring separately = scene_during(separate, 2, 1.7, 2.3);
  ASSERT_EQ(flatten(during).shared_meshes.size(), 2U);
  const RenderOptions options{.mode = RenderMode::direct, .samples = 4};
  const RenderedFrame frame = make_renderer(during, options)->render(capture);
  const RenderedFrame expected = make_renderer(separately, options)->render(capture);
  expect_same(frame, expected);
  const RenderedFrame at_rest =
      make_renderer(during.now, options)->render(all_of(still(camera(), {})));
  EXPECT_GT(difference(frame, at_rest, 1).colors, 1000);
}

TEST(SharedMesh, HasTheTruthOfMeshesOfTheirOwn) {
  const Scene scene = moving(copies());
  const Scene separate = moving(apart(copies()));
  const Scene now = scene_at(scene, 1);
  const Scene next = scene_at(scene, 1.1);
  const Scene now_apart = scene_at(separate, 1);
  const Scene next_apart = scene_at(separate, 1.1);
  const PointTracer tracer(now);
  const PointTracer next_tracer(next);
  const PointTracer tracer_apart(now_apart);
  const PointTracer next_apart_tracer(next_apart);
  const PointImage points = tracer.trace(camera(), {});
  const PointImage expected = tracer_apart.trace(camera(), {});
  const cv::Mat_<cv::Vec2f> flow = optical_flow(points, {next_tracer, camera(), {}});
  const cv::Mat_<cv::Vec2f> expected_flow =
      optical_flow(expected, {next_apart_tracer, camera(), {}});
  int differing = 0;
  for (int v = 0; v < flow.rows; ++v) {
    for (int u = 0; u < flow.cols; ++u) {
      differing += cv::norm(flow(v, u) - expected_flow(v, u)) > 1e-4 ? 1 : 0;
    }
  }
  const int few = static_cast<int>(flow.total() / 1000);
  EXPECT_LE(differing, few);
  EXPECT_LE(cv::countNonZero(moved_points(points, tracer, next_tracer) !=
                             moved_points(expected, tracer_apart, next_apart_tracer)),
            few);
  EXPECT_LE(cv::countNonZero(occlusion(points, {next_tracer, camera(), {}}) !=
                             occlusion(expected, {next_apart_tracer, camera(), {}})),
            few);
  EXPECT_LE(cv::countNonZero(instance_truth(points, tracer.scene()) !=
                             instance_truth(expected, tracer_apart.scene())),
            few);
}

TEST(SharedMesh, IsAsFarAwayAsMeshesOfTheirOwn) {
  const Scene scene = copies();
  const Scene separate = apart(scene);
  const SurfaceTracer shared(scene, 0.1);
  const SurfaceTracer own(separate, 0.1);
  for (const Eigen::Vector3f& point :
       {Eigen::Vector3f(0, 0, -2), Eigen::Vector3f(0.4F, 0.3F, -0.4F), Eigen::Vector3f(-1, 1, 0)}) {
    EXPECT_NEAR(distance_to_surface(shared.embree(), shared.world(), point, 9),
                distance_to_surface(own.embree(), own.world(), point, 9), 1e-5);
    const std::vector<Eigen::Vector3f> ways = {{0.1F, 0.2F, 1}, {-0.3F, -0.1F, 1}, {0, 0.3F, 1}};
    const std::vector<ProbeHit> hits = probe(shared.embree(), shared.world(), point, ways);
    const std::vector<ProbeHit> expected = probe(own.embree(), own.world(), point, ways);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_NEAR(hits[i].distance, expected[i].distance, 1e-5);
      EXPECT_EQ(hits[i].front, expected[i].front);
    }
  }
  const SurfaceView view = shared.trace(camera(), {});
  const SurfaceView expected = own.trace(camera(), {});
  EXPECT_LE(cv::countNonZero(cv::abs(view.light_share - expected.light_share) > 1e-3F), 20);
}

}  // namespace
}  // namespace synth
