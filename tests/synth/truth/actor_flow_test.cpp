#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/scene_file.h"
#include "synth/ray_tracing/point_tracer.h"
#include "synth/scene/scene_motion.h"
#include "synth/truth/motion_truth.h"
#include "tests/support/error_text.h"
#include "tests/support/gltf_document.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using support::error_text;
using testing::HasSubstr;

constexpr double kBend = std::numbers::pi / 2;  // rad, of the lower joint within the cycle of 1 s
constexpr double kKnee = 1;                     // m, the height of the lower joint

/// The vertices of a strip of 1 x 2 m that faces +z, from the bottom up, and the upper joint's
/// weights.
constexpr std::array<double, 3> kHeights = {0, 1, 2};
constexpr std::array<float, 3> kUpper = {0, 0.5F, 1};

/// A strip of which the upper joint holds the top, and the lower one turns the bottom about x in a
/// cycle of 1 s.
GltfDocument strip_document() {
  GltfDocument document;
  std::vector<float> positions;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (std::size_t row = 0; row < 3; ++row) {
    for (const float x : {-0.5F, 0.5F}) {
      positions.insert(positions.end(), {x, static_cast<float>(kHeights[row]), 0});
      joints.insert(joints.end(), {0, 1, 0, 0});
      weights.insert(weights.end(), {kUpper[row], 1 - kUpper[row], 0, 0});
    }
  }
  nlohmann::json attributes;
  attributes["POSITION"] = document.add_accessor<float>("VEC3", kFloat, 6, positions);
  attributes["JOINTS_0"] = document.add_accessor<std::uint8_t>("VEC4", kUnsignedByte, 6, joints);
  attributes["WEIGHTS_0"] = document.add_accessor<float>("VEC4", kFloat, 6, weights);
  const auto indices = document.add_accessor<std::uint16_t>("SCALAR", kUnsignedShort, 12,
                                                            {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4});
  document.json["materials"] = {{{"name", "cloth"}, {"doubleSided", true}}};
  document.json["meshes"] = {
      {{"name", "strip"},
       {"primitives", {{{"attributes", attributes}, {"indices", indices}, {"material", 0}}}}}};
  std::vector<float> binds(32, 0);
  for (std::size_t joint = 0; joint < 2; ++joint) {
    for (std::size_t i = 0; i < 4; ++i) {
      binds[16 * joint + 5 * i] = 1;
    }
    binds[16 * joint + 13] = -static_cast<float>(kKnee);
  }
  document.json["skins"] = {
      {{"joints", {1, 2}},
       {"inverseBindMatrices", document.add_accessor<float>("MAT4", kFloat, 2, binds)}}};
  document.json["nodes"] = {{{"name", "strip"}, {"mesh", 0}, {"skin", 0}},
                            {{"name", "upper"}, {"translation", {0, kKnee, 0}}, {"children", {2}}},
                            {{"name", "lower"}}};
  document.json["scenes"] = {{{"nodes", {0, 1}}}};
  const auto times = document.add_accessor<float>("SCALAR", kFloat, 2, {0, 1});
  document.json["accessors"].back()["min"] = {0};
  document.json["accessors"].back()["max"] = {1};
  const auto half = static_cast<float>(kBend / 2);
  const auto turns = document.add_accessor<float>(
      "VEC4", kFloat, 2, {0, 0, 0, 1, std::sin(half), 0, 0, std::cos(half)});
  document.json["animations"] = {
      {{"name", "bend"},
       {"samplers", {{{"input", times}, {"output", turns}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}}}}}};
  return document;
}

/// A wall of 20 x 20 m at z = -4, of a file without motion.
GltfDocument wall_document() {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {
      {{"mesh", 0}, {"translation", {-10, -10, -4}}, {"scale", {40, 40, 1}}, {"name", "wall"}}};
  document.json["meshes"][0]["primitives"][0]["material"] = 0;
  document.json["materials"] = {{{"name", "plaster"}}};
  return document;
}

/// A strip that goes in front of the wall, in a folder of its own.
class ActorTest : public testing::Test {
 public:
  ActorTest() {
    actor.file = strip_document().write(strip_folder_);
    actor.path = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 2}};
    actor.speed = 0.8;
    actor.start = 0.25;
    actor.turn_time = 0.2;
    wall_ = wall_document().write(wall_folder_);
  }

  SceneFile file() const { return SceneFile(wall_, {}, {actor}); }

  /// Where the actor's origin is, and its turn about y, rad, on the first leg.
  Eigen::Affine3d T_world_actor(double time) const {
    const double way = std::max(time - actor.start, 0.0) * actor.speed;
    return Eigen::Translation3d(-1 + way, 0, 0) * Eigen::AngleAxisd(kBend, Vector3d::UnitY());
  }

  /// A vertex of the strip in the world by the formula of linear blend skinning.
  Vector3d vertex(int index, double time) const {
    const auto row = static_cast<std::size_t>(index / 2);
    const Vector3d rest(index % 2 == 0 ? -0.5 : 0.5, kHeights[row], 0);
    const double cycle = std::fmod(std::max(time - actor.start, 0.0), 1.0);
    const Vector3d knee(0, kKnee, 0);
    const Vector3d bent =
        knee + Eigen::AngleAxisd(kBend * cycle, Vector3d::UnitX()) * (rest - knee);
    return T_world_actor(time) * (kUpper[row] * rest + (1 - kUpper[row]) * bent);
  }

  ActorOptions actor;

 private:
  support::TempFolder strip_folder_;
  support::TempFolder wall_folder_;
  std::filesystem::path wall_;
};

/// Returns the pose of a camera that is not tilted.
vo::SE3 looking_from(const Vector3d& eye, const Vector3d& target) {
  const Vector3d forward = (target - eye).normalized();
  const Vector3d down = -Vector3d::UnitY();
  Eigen::Matrix3d R_world_camera;
  R_world_camera << down.cross(forward), down, forward;
  return {Eigen::Quaterniond(R_world_camera), eye};
}

/// Where the middle of the strip's top edge is, of which the upper joint alone decides.
Vector3d top_of(const Scene& scene, double time) {
  const Scene now = scene_at(scene, time);
  const Instance& instance = now.instances.at(1);
  const Mesh& mesh = now.meshes.at(at(instance.mesh));
  return instance.T_world_mesh *
         Vector3d((mesh.positions.at(4) + mesh.positions.at(5)).cast<double>() / 2);
}

TEST_F(ActorTest, IsSpeedTimesTimeAlongItsPath) {
  const SceneFile there = file();
  const auto expect_at = [&](double time, const Vector3d& place) {
    const Vector3d top = top_of(there.scene(), time);
    EXPECT_LT((top - place - Vector3d(0, 2, 0)).norm(), 1e-5)
        << "m, at " << time << " s: " << top.transpose();
  };
  expect_at(0, {-1, 0, 0});
  expect_at(0.25, {-1, 0, 0});
  for (const double t : {0.1, 0.7, 1.9, 2.5}) {
    expect_at(0.25 + t, {-1 + 0.8 * t, 0, 0});
  }
  expect_at(0.25 + 2.5 + 1, {1, 0, 0.8});
  expect_at(0.25 + 5, {1, 0, 2});
  expect_at(100, {1, 0, 2});
}

TEST_F(ActorTest, GoesFromTheLastPointToTheFirstIfItLoops) {
  actor.loop = true;
  const double back = std::sqrt(8.0);
  const double round = (4 + back) / 0.8;
  const SceneFile there = file();
  const Vector3d half_way = top_of(there.scene(), 0.25 + (4 + back / 2) / 0.8);
  EXPECT_LT((half_way - Vector3d(0, 2, 1)).norm(), 1e-5) << half_way.transpose();
  EXPECT_LT((top_of(there.scene(), 7) - top_of(there.scene(), 7 + 3 * round)).norm(), 1e-5);
}

TEST_F(ActorTest, FlowIsTheDifferenceOfItsVerticesInTheImage) {
  const SceneFile there = file();
  const Scene& scene = there.scene();
  const vo::PinholeCamera camera = wide_camera();
  const vo::SE3 T_world_camera = looking_from({2, 1, 1}, {-0.7, 1, 0});
  const double now = 0.6;
  const double next = 0.85;
  const Scene scene_now = scene_at(scene, now);
  const Scene scene_next = scene_at(scene, next);
  const PointTracer tracer_now(scene_now);
  const PointTracer tracer_next(scene_next);
  const PointImage points = tracer_now.trace(camera, T_world_camera);
  const FlowImage flow = optical_flow(points, NextView{tracer_next, camera, T_world_camera});
  const auto moved = moved_points(points, tracer_now, tracer_next);
  const vo::SE3 T_camera_world = T_world_camera.inverse();
  int checked = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const TrianglePoint& point = points.at(u, v);
      if (!point.exists() || tracer_now.scene().meshes[at(point.mesh)].instance != 1) {
        EXPECT_EQ(moved(v, u), 0);
        continue;
      }
      const Mesh& mesh = *tracer_now.scene().meshes[at(point.mesh)].mesh;
      Vector3d p_now = Vector3d::Zero();
      Vector3d p_next = Vector3d::Zero();
      for (int i = 0; i < 3; ++i) {
        const int index = mesh.triangles[at(point.triangle)][at(i)];
        p_now += point.weights[i] * vertex(index, now);
        p_next += point.weights[i] * vertex(index, next);
      }
      EXPECT_EQ(moved(v, u), 255);
      const Eigen::Vector2d pixel = camera.project(T_camera_world * p_now);
      EXPECT_LT((pixel - Eigen::Vector2d(u, v)).norm(), 1e-4) << "px";
      const Eigen::Vector2d expected = camera.project(T_camera_world * p_next) - pixel;
      EXPECT_LT((expected - Eigen::Vector2d(flow(v, u)[0], flow(v, u)[1])).norm(), 2e-4) << "px";
      EXPECT_GT(expected.norm(), 0.01) << "px";
      ++checked;
    }
  }
  EXPECT_GT(checked, 100) << "pixels";
}

TEST_F(ActorTest, StandsBesideTheScenesOwnThingsUnderItsOwnNames) {
  const SceneFile there = file();
  EXPECT_THAT(moving_instances(there.scene()), testing::ElementsAre(false, true));
  ASSERT_EQ(there.scene().materials.size(), 2U);
  EXPECT_EQ(there.scene().materials[1].name, "cloth");
  const SceneLabels& labels = there.labels();
  ASSERT_EQ(labels.files.size(), 2U);
  EXPECT_EQ(node_path(labels.files[at(labels.instances[1].file)], labels.instances[1].node),
            "strip");
  EXPECT_EQ(labels.instances[0].file, 0);
  EXPECT_EQ(labels.materials[1].file, 1);
}

TEST_F(ActorTest, HoldsStillBeforeAndAfterItsWay) {
  const SceneFile there = file();
  const auto corners = [&](double time) { return world_corners(scene_at(there.scene(), time)); };
  EXPECT_EQ(corners(-1), corners(0.25));
  EXPECT_EQ(corners(0.25 + 5), corners(60));
  EXPECT_NE(corners(0.25 + 4.9), corners(60));
}

TEST_F(ActorTest, IsRefusedWhereItsFileLacksWhatIsAskedFor) {
  actor.animation = "run";
  EXPECT_THAT(error_text([&] { file().scene(); }),
              HasSubstr("has no animation \"run\", expected one of 0 \"bend\""));
  actor.animation = "none";
  actor.skinned = true;
  EXPECT_NO_THROW(file().scene());
}

TEST_F(ActorTest, IsRefusedWithoutASkinThatBendsIt) {
  const support::TempFolder folder;
  actor.file = wall_document().write(folder);
  actor.skinned = true;
  EXPECT_THAT(error_text([&] { file().scene(); }), HasSubstr("has no mesh that a skin bends"));
  actor.skinned = false;
  EXPECT_NO_THROW(file().scene());
  actor.animation = "walk";
  EXPECT_THAT(error_text([&] { file().scene(); }),
              HasSubstr("has no animation \"walk\", expected none"));
}

TEST(ActorOptions, AreRefusedOutOfRange) {
  const auto error_of = [](const auto& change) {
    ActorOptions options{.file = "a.gltf", .path = {{0, 0, 0}, {1, 0, 0}}};
    change(options);
    return error_text([&] { options.validate(); });
  };
  EXPECT_EQ(error_of([](ActorOptions& o) { o.speed = 0; }),
            "actor: speed: is 0, expected a positive number of m/s");
  EXPECT_EQ(error_of([](ActorOptions& o) { o.path.pop_back(); }),
            "actor: path: has 1 points, expected at least two, [[x, y, z], ...]");
  EXPECT_THAT(error_of([](ActorOptions& o) { o.path.back() = o.path.front(); }),
              HasSubstr("points 0 and 1 are 0 m apart"));
  EXPECT_THAT(error_of([](ActorOptions& o) { o.path.back().x() = std::nan(""); }),
              HasSubstr("points 0 and 1 are nan m apart"));
  EXPECT_THAT(error_of([](ActorOptions& o) { o.path.back().x() = 1e6; }),
              HasSubstr("its path takes 1e+06 s"));
  EXPECT_THAT(error_of([](ActorOptions& o) { o.turn_time = 0; }), HasSubstr("turn_time: is 0"));
  EXPECT_THAT(error_of([](ActorOptions& o) { o.scale = -1; }), HasSubstr("scale: is -1"));
  EXPECT_THAT(error_of([](ActorOptions& o) { o.file.clear(); }), HasSubstr("expected a glTF file"));
}

}  // namespace
}  // namespace synth
