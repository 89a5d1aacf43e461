#include "synth/gltf/instancing.h"

#include <cstddef>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/gltf_summary.h"
#include "synth/scene/scene_motion.h"
#include "tests/support/gltf_errors.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

json& attributes_of(GltfDocument& document) {
  return document.json["nodes"][0]["extensions"][kInstancing]["attributes"];
}

/// Three triangles below a node that is two metres up: one moved, one turned as well, one mirrored.
GltfDocument instancing_document() {
  GltfDocument document = triangle_document();
  document.json["extensionsUsed"] = {kInstancing};
  document.json["extensionsRequired"] = {kInstancing};
  document.json["nodes"][0]["translation"] = {0, 2, 0};
  json attributes;
  attributes["TRANSLATION"] =
      document.add_accessor<float>("VEC3", kFloat, 3, {1, 0, 0, 0, 0, 5, 0, 0, 0});
  attributes["ROTATION"] = document.add_accessor<std::int16_t>(  // half a turn about z
      "VEC4", kShort, 3, {0, 0, 0, 32767, 0, 0, 32767, 0, 0, 0, 0, 32767});
  document.json["accessors"].back()["normalized"] = true;
  attributes["SCALE"] =
      document.add_accessor<float>("VEC3", kFloat, 3, {1, 1, 1, 1, 1, 1, -1, 3, 1});
  attributes["_ID"] = 0;
  attributes_of(document) = attributes;
  return document;
}

/// Where a point of the mesh is in each instance.
std::vector<Vector3d> points_of(const Scene& scene, const Vector3d& p_mesh) {
  std::vector<Vector3d> points;
  for (const Instance& instance : scene.instances) {
    points.emplace_back(instance.T_world_mesh * p_mesh);
  }
  return points;
}

testing::Matcher<Vector3d> near(const Vector3d& expected) {
  return testing::ResultOf([expected](const Vector3d& point) { return (point - expected).norm(); },
                           testing::Lt(1e-6));
}

TEST(GltfInstancing, PutsTheMeshWhereTheAttributesSay) {
  const support::TempFolder folder;
  const GltfSummary summary = summarize_gltf(instancing_document().write(folder), {});
  EXPECT_TRUE(summary.notes.empty());
  EXPECT_EQ(summary.scene.meshes.size(), 1U);
  EXPECT_THAT(points_of(summary.scene, {1, 1, 0}),
              ElementsAre(near({2, 3, 0}), near({-1, 1, 5}), near({-1, 5, 0})));
  EXPECT_EQ(summary.triangles, 1U) << "as the Khronos validator counts";
  EXPECT_EQ(summary.bounds_at_rest.max(), Vector3d(2, 5, 5));
}

TEST(GltfInstancing, LeavesOutWhatIsNotGiven) {
  GltfDocument document = instancing_document();
  attributes_of(document).erase("ROTATION");
  attributes_of(document).erase("TRANSLATION");
  const support::TempFolder folder;
  EXPECT_THAT(points_of(load_gltf(document.write(folder)), {1, 1, 0}),
              ElementsAre(near({1, 3, 0}), near({1, 3, 0}), near({-1, 5, 0})));
}

TEST(GltfInstancing, MovesWithItsNodeAndMorphsByItsWeights) {
  GltfDocument document = instancing_document();
  document.primitive()["targets"] = {{{"POSITION", 0}}};
  const std::size_t times = document.add_accessor<float>("SCALAR", kFloat, 2, {0, 1});
  document.json["accessors"].back()["min"] = {0};
  document.json["accessors"].back()["max"] = {1};
  const std::size_t path = document.add_accessor<float>("VEC3", kFloat, 2, {0, 2, 0, 0, 2, 8});
  const std::size_t weights = document.add_accessor<float>("SCALAR", kFloat, 2, {0, 1});
  document.json["animations"] = {
      {{"samplers",
        {{{"input", times}, {"output", path}}, {{"input", times}, {"output", weights}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
         {{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
  const support::TempFolder folder;
  const Scene scene = load_gltf(document.write(folder));
  EXPECT_THAT(moving_instances(scene), ElementsAre(true, true, true));
  const Scene then = scene_at(scene, 0.5);
  EXPECT_THAT(points_of(then, {1, 1, 0}),
              ElementsAre(near({2, 3, 4}), near({-1, 1, 9}), near({-1, 5, 4})));
  for (const Mesh& mesh : then.meshes) {
    EXPECT_EQ(mesh.positions[1], Eigen::Vector3f(1.5F, 0, 0));
  }
}

TEST(GltfInstancing, IsOfTheNodesOfTheScene) {
  GltfDocument document = instancing_document();
  document.json["nodes"].push_back({{"mesh", 0}});
  document.json["scenes"][0]["nodes"] = {1};
  const support::TempFolder folder;
  EXPECT_EQ(load_gltf(document.write(folder)).instances.size(), 1U);
}

/// Instances of 1000 triangles, all of whose corners are zero, as glTF reads accessors without
/// data.
GltfDocument crowd(std::size_t instances) {
  GltfDocument document;
  document.json["accessors"] = {
      {{"type", "VEC3"}, {"componentType", kFloat}, {"count", 3000}},
      {{"type", "VEC3"}, {"componentType", kFloat}, {"count", instances}}};
  document.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
  document.json["nodes"] = {{{"mesh", 0}}};
  attributes_of(document)["TRANSLATION"] = 1;
  return document;
}

TEST(GltfInstancing, NeedsMemoryForOneMeshUnlessEachNeedsACopy) {
  GltfDocument document = crowd(20'000);  // copies would need more than a GiB
  const support::TempFolder folder;
  EXPECT_EQ(load_gltf(document.write(folder)).instances.size(), 20'000U);
  document.json["nodes"][0]["scale"] = {1, 1, 0};
  EXPECT_THAT(error_of(document), HasSubstr("bytes of memory, expected at most"));
  EXPECT_THAT(error_of(crowd(200'000)), HasSubstr("more than 536870912 vertices in all"));
}

class BadInstancing : public testing::TestWithParam<Replacement> {};

TEST_P(BadInstancing, IsNamed) {
  GltfDocument document = instancing_document();
  document.json[json::json_pointer(GetParam().pointer)] = GetParam().value;
  EXPECT_THAT(error_of(document), HasSubstr(GetParam().message));
}

#define ATTRIBUTES "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes"
INSTANTIATE_TEST_SUITE_P(
    Instancing, BadInstancing,
    testing::Values(
        Replacement{ATTRIBUTES, json::object(), "has none of TRANSLATION, ROTATION and SCALE"},
        Replacement{
            ATTRIBUTES, 5,
            "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes: is 5, expected an object"},
        Replacement{ATTRIBUTES "/SCALE", 9, "SCALE is 9, expected"},
        Replacement{ATTRIBUTES "/SCALE", 1, "SCALE: is of type SCALAR, expected VEC3"},
        Replacement{ATTRIBUTES "/ROTATION", 0, "ROTATION: is of type VEC3, expected VEC4"},
        Replacement{"/accessors/3/normalized", false, "ROTATION: has components of type 5122"},
        Replacement{"/accessors/4/count", 2, "SCALE has 2 elements, expected 3"},
        Replacement{"/accessors/3/byteOffset", 4, "accessors[3]"},
        Replacement{"/accessors/2/count", 60'000'000, "accessors[2]"},
        Replacement{"/bufferViews/3/byteOffset", 0, "is not of length 1, expected a unit"}));
#undef ATTRIBUTES

}  // namespace
}  // namespace synth
