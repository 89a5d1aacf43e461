#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/gltf.h"
#include "synth/scene/scene_motion.h"
#include "tests/support/error_text.h"
#include "tests/support/gltf_document.h"
#include "tests/support/load_document.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using support::TempFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;

constexpr double kMotionRounding = 1e-6;  // m, of floats

/// Adds to an animation a channel with keys at whole seconds; weights are those of two targets.
void animate(GltfDocument& document, int node, const std::string& path,
             const std::vector<float>& values, const std::string& interpolation = "LINEAR") {
  const std::size_t width = path == "weights" ? 1 : path == "rotation" ? 4 : 3;
  const std::size_t rows = values.size() / width;
  const std::size_t keys =
      rows / ((interpolation == "CUBICSPLINE" ? 3 : 1) * (path == "weights" ? 2 : 1));
  std::vector<float> times;
  for (std::size_t i = 0; i < keys; ++i) {
    times.push_back(static_cast<float>(i));
  }
  const char* type = width == 1 ? "SCALAR" : width == 4 ? "VEC4" : "VEC3";
  json& animation = document.json["animations"][0];
  animation["samplers"].push_back({{"input", document.add_accessor("SCALAR", kFloat, keys, times)},
                                   {"output", document.add_accessor(type, kFloat, rows, values)},
                                   {"interpolation", interpolation}});
  animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                   {"target", {{"node", node}, {"path", path}}}});
}

std::vector<Vector3d> corners_at(const Scene& scene, double time) {
  return world_corners(scene_at(scene, time));
}

TEST(SceneMotion, AStillSceneHasNone) {
  const Scene scene = load(triangle_document());
  EXPECT_FALSE(moves(scene));
  EXPECT_THAT(scene.motion.nodes, IsEmpty());
  EXPECT_THAT(corners_at(scene, 5), Pointwise(IsClose(kMotionRounding), world_corners(scene)));
}

TEST(SceneMotion, MovesAChildWithItsParent) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}};
  const auto half = static_cast<float>(std::sqrt(0.5));
  animate(document, 0, "rotation", {0, 0, 0, 1, 0, 0, half, half});  // a quarter turn about z
  animate(document, 0, "scale", {1, 1, 1, 3, 3, 3});
  const Scene scene = load(document);
  EXPECT_TRUE(moves(scene));
  const std::vector<Vector3d> at_rest = {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  const std::vector<Vector3d> at_end = {{0, 3, 0}, {0, 6, 0}, {-3, 3, 0}};
  const double eighth = 2 * std::sqrt(0.5);  // scale 2 times the cosine of 45 degrees
  const std::vector<Vector3d> halfway = {
      {eighth, eighth, 0}, {2 * eighth, 2 * eighth, 0}, {0, 2 * eighth, 0}};
  EXPECT_THAT(world_corners(scene), Pointwise(IsClose(kMotionRounding), at_rest));
  EXPECT_THAT(corners_at(scene, 0.5), Pointwise(IsClose(kMotionRounding), halfway));
  EXPECT_THAT(corners_at(scene, 9), Pointwise(IsClose(kMotionRounding), at_end));
}

TEST(SceneMotion, LoopsWhenAskedTo) {
  GltfDocument document = triangle_document();
  animate(document, 0, "translation", {0, 0, 0, 4, 0, 0});
  EXPECT_EQ(corners_at(load(document), 2.25).at(0), Vector3d(4, 0, 0));
  EXPECT_EQ(corners_at(load(document, {.loop = true}), 2.25).at(0), Vector3d(1, 0, 0));
}

TEST(SceneMotion, KeepsInstancesAndTriangles) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}};
  document.json["scenes"][0]["nodes"] = {0, 1};
  animate(document, 1, "translation", {0, 0, 1, 0, 5, 1});
  const Scene scene = load(document);
  const Scene later = scene_at(scene, 1);
  EXPECT_THAT(moving_instances(scene), ElementsAre(false, true));
  ASSERT_EQ(later.instances.size(), 2U);
  EXPECT_EQ(later.instances[0].mesh, scene.instances[0].mesh);
  EXPECT_EQ(later.meshes[0].triangles, scene.meshes[0].triangles);
  EXPECT_TRUE(later.motion.nodes.empty());
}

TEST(SceneMotion, AConstantCurveMovesNothing) {
  GltfDocument document = triangle_document();
  animate(document, 0, "translation", {1, 2, 3, 1, 2, 3});
  EXPECT_FALSE(moves(load(document)));
}

TEST(SceneMotion, MovesLightsAndCameras) {
  GltfDocument document = triangle_document();
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  document.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  document.json["nodes"] = {
      {{"mesh", 0}}, {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  document.json["scenes"][0]["nodes"] = {0, 1};
  animate(document, 1, "translation", {0, 0, 0, 2, 4, 6});
  const Scene scene = load(document);
  EXPECT_TRUE(moves(scene));
  EXPECT_TRUE(moves_cameras(scene));
  EXPECT_THAT(moving_instances(scene), ElementsAre(false));
  EXPECT_EQ(scene_at(scene, 0.5).lights.at(0).position, Vector3d(1, 2, 3));
  EXPECT_EQ(scene_at(scene, 0.5).cameras.at(0).T_world_camera.translation(), Vector3d(1, 2, 3));
}

/// Two targets: the first lifts every vertex by (0, 0, 1), the second moves only the last one.
GltfDocument morph_document() {
  GltfDocument document = triangle_document();
  const std::size_t lift =
      document.add_accessor<float>("VEC3", kFloat, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  const std::size_t pull =
      document.add_accessor<float>("VEC3", kFloat, 3, {0, 0, 0, 0, 0, 0, 0, 2, 0});
  document.primitive()["targets"] = {{{"POSITION", lift}}, {{"POSITION", pull}}};
  return document;
}

TEST(SceneMotion, AddsMorphTargetsByTheirWeights) {
  GltfDocument document = morph_document();
  animate(document, 0, "weights", {0, 0, 1, 0.5F});  // two keys of two weights
  const Scene scene = load(document);
  const std::vector<Vector3d> halfway = {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1.5, 0.5}};
  EXPECT_THAT(corners_at(scene, 0.5), Pointwise(IsClose(kMotionRounding), halfway));
  EXPECT_THAT(moving_instances(scene), ElementsAre(true));
}

TEST(SceneMotion, AppliesTheWeightsOfTheMeshAndBeforeThemThoseOfTheNode) {
  GltfDocument document = morph_document();
  document.json["meshes"][0]["weights"] = {3, 0};
  EXPECT_EQ(world_corners(load(document)).at(0), Vector3d(0, 0, 3));
  document.json["nodes"][0]["weights"] = {0, 1};
  const Scene scene = load(document);
  EXPECT_EQ(world_corners(scene).at(0), Vector3d(0, 0, 0));
  EXPECT_EQ(world_corners(scene).at(2), Vector3d(0, 3, 0));
  EXPECT_FALSE(moves(scene));
}

/// The triangle follows two joints: the first vertex joint A, the second B, the third both by half.
/// A was bound at the origin, B at (1, 0, 0). The mesh's own node is elsewhere, which must not
/// matter.
GltfDocument skin_document() {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["JOINTS_0"] = document.add_accessor<std::uint8_t>(
      "VEC4", kUnsignedByte, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
  document.primitive()["attributes"]["WEIGHTS_0"] =
      document.add_accessor<float>("VEC4", kFloat, 3, {1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0});
  std::vector<float> matrices(32, 0);
  for (const std::size_t i : {0U, 5U, 10U, 15U, 16U, 21U, 26U, 31U}) {
    matrices[i] = 1;
  }
  matrices[28] = -1;
  document.json["skins"] = {
      {{"joints", {1, 2}},
       {"inverseBindMatrices", document.add_accessor("MAT4", kFloat, 2, matrices)}}};
  document.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 60, 70}}},
                            {{"children", {2}}},
                            {{"translation", {1, 0, 0}}}};
  document.json["scenes"][0]["nodes"] = {0, 1};
  return document;
}

TEST(SceneMotion, ASkinnedMeshStandsWhereItsJointsAre) {
  const std::vector<Vector3d> bound = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THAT(world_corners(load(skin_document())), Pointwise(IsClose(kMotionRounding), bound));
}

TEST(SceneMotion, VerticesFollowTheirJointsByWeight) {
  GltfDocument document = skin_document();
  const auto half = static_cast<float>(std::sqrt(0.5));
  animate(document, 2, "rotation", {0, 0, 0, 1, 0, 0, half, half});  // B: a quarter turn about z
  animate(document, 2, "translation", {1, 0, 0, 1, 0, 2});
  const Scene scene = load(document);
  // B takes p to R (p - (1, 0, 0)) + (1, 0, 2): the third vertex (0, 1, 0) to (0, -1, 2), and half
  // way there from where A leaves it is (0, 0, 1).
  const std::vector<Vector3d> expected = {{0, 0, 0}, {1, 0, 2}, {0, 0, 1}};
  EXPECT_THAT(corners_at(scene, 1), Pointwise(IsClose(kMotionRounding), expected));
  EXPECT_THAT(moving_instances(scene), ElementsAre(true));
}

TEST(SceneMotion, NormalsTurnWithTheirJoints) {
  GltfDocument document = skin_document();
  document.primitive()["attributes"]["NORMAL"] =
      document.add_accessor<float>("VEC3", kFloat, 3, {1, 0, 0, 1, 0, 0, 1, 0, 0});
  const auto half = static_cast<float>(std::sqrt(0.5));
  animate(document, 2, "rotation", {0, 0, 0, 1, 0, 0, half, half});
  const Mesh mesh = scene_at(load(document), 1).meshes.at(0);
  EXPECT_TRUE(mesh.normals.at(0).isApprox(Eigen::Vector3f::UnitX()));
  EXPECT_TRUE(mesh.normals.at(1).isApprox(Eigen::Vector3f::UnitY()));
}

TEST(SceneMotion, KeepsTheEnvironment) {
  GltfDocument document = triangle_document();
  animate(document, 0, "translation", {0, 0, 0, 1, 0, 0});
  Scene scene = load(document);
  scene.environment.radiance = cv::Mat_<cv::Vec3f>(1, 2, cv::Vec3f(1, 2, 3));
  scene.environment.turn = 0.5;
  for (const Scene& moment : {scene_at(scene, 0.5), scene_at_rest(scene)}) {
    EXPECT_FALSE(moment.environment.empty());
    EXPECT_EQ(moment.environment.turn, 0.5);
  }
}

TEST(SceneMotion, PlaysTheAnimationThatIsAskedFor) {
  GltfDocument document = triangle_document();
  animate(document, 0, "translation", {0, 0, 0, 1, 0, 0});
  document.json["animations"].push_back(document.json["animations"][0]);
  document.json["animations"][0]["name"] = "walk";
  document.json["animations"][1]["name"] = "run";
  document.json["animations"][1]["samplers"][0]["output"] =
      document.add_accessor<float>("VEC3", kFloat, 2, {0, 0, 0, 7, 0, 0});
  Notes notes;
  EXPECT_EQ(corners_at(load(document, {}, &notes), 1).at(0).x(), 1);
  EXPECT_THAT(notes, Contains(HasSubstr("that move what an earlier one moves")));
  EXPECT_EQ(corners_at(load(document, {.animation = "run"}), 1).at(0).x(), 7);
  EXPECT_EQ(corners_at(load(document, {.animation = "1"}), 1).at(0).x(), 7);
  EXPECT_FALSE(moves(load(document, {.animation = "none"})));
  EXPECT_THAT(support::error_text([&] { load(document, {.animation = "fly"}); }),
              HasSubstr("has no animation \"fly\", expected one of 0 \"walk\", 1 \"run\""));
}

TEST(SceneMotion, ReadsTheSceneThatIsAskedFor) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}};
  document.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}, {"name", "upper"}}};
  EXPECT_EQ(world_corners(load(document, {.scene = "upper"})).at(0).z(), 1);
  EXPECT_EQ(world_corners(load(document, {.scene = "0"})).at(0).z(), 0);
  EXPECT_THAT(support::error_text([&] { load(document, {.scene = "2"}); }),
              HasSubstr("has no scene \"2\""));
}

}  // namespace
}  // namespace synth
