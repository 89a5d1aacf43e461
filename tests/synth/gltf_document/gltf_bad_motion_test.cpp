#include <cstddef>
#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gltf_errors.h"

namespace synth {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The triangle with a joint, a target and an animation, all as they should be.
GltfDocument moving_document() {
  GltfDocument document = triangle_document();
  json& primitive = document.primitive();
  primitive["attributes"]["JOINTS_0"] = document.add_accessor<std::uint8_t>(
      "VEC4", kUnsignedByte, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  primitive["attributes"]["WEIGHTS_0"] =
      document.add_accessor<float>("VEC4", kFloat, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  primitive["targets"] = {{{"POSITION", 0}}};
  document.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, json::object()};
  document.json["scenes"] = {{{"nodes", {0, 1}}}};
  document.json["skins"] = {{{"joints", {1}}}};
  const std::size_t times = document.add_accessor<float>("SCALAR", kFloat, 2, {0, 1});
  const std::size_t values = document.add_accessor<float>("VEC3", kFloat, 2, {0, 0, 0, 1, 1, 1});
  document.json["animations"] = {
      {{"samplers", {{{"input", times}, {"output", values}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
  return document;
}

TEST(BadGltf, NothingIsWrongWithWhatTheNextTestsSpoil) {
  const support::TempFolder folder;
  EXPECT_EQ(error_of(moving_document().write(folder)), "");
}

class BadMotion : public testing::TestWithParam<Replacement> {};

TEST_P(BadMotion, IsNamed) {
  GltfDocument document = moving_document();
  document.json[json::json_pointer(GetParam().pointer)] = GetParam().value;
  EXPECT_THAT(error_of(document), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Motion, BadMotion,
    testing::Values(
        Replacement{"/skins/0/joints", json::array(), "skins[0]: has no joints"},
        Replacement{"/skins/0/joints", {1, 1}, "names a joint twice"},
        Replacement{"/skins/0/inverseBindMatrices", 0, "is of type VEC3, expected MAT4"},
        Replacement{"/nodes/0/weights", {1, 2}, "nodes[0]: has 2 weights"},
        Replacement{"/meshes/0/weights", {1, 2}, "meshes[0]: has 2 weights"},
        Replacement{"/nodes/1", {{"skin", 0}}, "nodes[1]: has a skin without a mesh"},
        Replacement{"/nodes/1/matrix",
                    {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                    "moves nodes[1], which has a matrix"},
        Replacement{"/meshes/0/primitives/0/targets", {{{"NORMAL", 0}}}, "moves NORMAL"},
        Replacement{"/meshes/0/primitives/0/targets", {{{"POSITION", 4}}}, "POSITION has 2"},
        Replacement{"/accessors/2/componentType", 5120, "JOINTS_0 has components of type 5120"},
        Replacement{"/animations/0/channels/0/sampler", 1, "sampler is 1"},
        Replacement{"/animations/0/channels/0/target/node", 2, "node is 2"},
        Replacement{"/animations/0/channels/0/target/path", "colour", "path is colour"},
        Replacement{"/animations/0/channels/0/target/path", "rotation", "expected VEC4"},
        Replacement{"/animations/0/channels/0/target/path", "weights", "expected a mesh"},
        Replacement{"/animations/0/samplers/0/input", 0, "input: is of type VEC3"},
        Replacement{"/animations/0/samplers/0/output", 0, "has 3 elements, expected 1"},
        Replacement{"/animations/0/samplers/0/interpolation", "SMOOTH", "interpolation is SMOOTH"},
        Replacement{"/animations/0/samplers/0/interpolation", "CUBICSPLINE", "expected 3"}));

TEST(BadGltf, JointOutOfRange) {
  GltfDocument document = moving_document();
  document.bytes[44] = 1;  // the first of the joints, after positions and indices
  EXPECT_THAT(error_of(document), HasSubstr("vertex 0 follows joint 1, expected one below the 1"));
}

TEST(BadGltf, SkinOnAMeshWithoutJoints) {
  GltfDocument document = moving_document();
  document.primitive()["attributes"].erase("JOINTS_0");
  document.primitive()["attributes"].erase("WEIGHTS_0");
  EXPECT_THAT(error_of(document), HasSubstr("nodes[0]: has a skin, but a primitive of meshes[0]"));
}

TEST(BadGltf, JointSetsWithAGap) {
  GltfDocument document = moving_document();
  json& attributes = document.primitive()["attributes"];
  attributes["JOINTS_1"] = attributes["JOINTS_0"];
  attributes["WEIGHTS_1"] = attributes["WEIGHTS_0"];
  attributes.erase("JOINTS_0");
  attributes.erase("WEIGHTS_0");
  EXPECT_THAT(error_of(document), HasSubstr("1 sets of joints but no JOINTS_0"));
}

/// Nodes 1, 2 and 3 in one tree, 4 alone; the skin follows 2 and 3.
GltfDocument tree_document() {
  GltfDocument document = moving_document();
  document.json["nodes"] = {document.json["nodes"][0],
                            {{"children", {2, 3}}},
                            json::object(),
                            json::object(),
                            json::object()};
  document.json["skins"] = {{{"joints", {2, 3}}, {"skeleton", 1}}};
  return document;
}

TEST(BadGltf, JointsOfTwoTrees) {
  GltfDocument document = tree_document();
  document.json["skins"][0] = {{"joints", {2, 4}}};
  EXPECT_THAT(error_of(document), HasSubstr("nodes[2] and nodes[4] have no root in common"));
}

TEST(BadGltf, SkeletonThatDoesNotLeadToAJoint) {
  const support::TempFolder folder;
  GltfDocument document = tree_document();
  EXPECT_EQ(error_of(document.write(folder)), "");
  document.json["skins"][0]["skeleton"] = 2;
  EXPECT_THAT(error_of(document), HasSubstr("nodes[2] does not lead to its joint nodes[3]"));
}

TEST(BadGltf, SceneWithoutTheJointsOfItsSkin) {
  GltfDocument document = tree_document();
  document.json["scenes"] = {{{"nodes", {0}}}};
  EXPECT_THAT(error_of(document), HasSubstr("scenes[0]: shows nodes[0] but not the joints"));
}

TEST(BadGltf, KeysOfRotationThatAreNoUnitQuaternions) {
  GltfDocument document = moving_document();
  json& animation = document.json["animations"][0];
  animation["samplers"][0]["output"] =
      document.add_accessor<float>("VEC4", kFloat, 2, {0, 0, 0, 1, 0, 0, 0, 2});
  animation["channels"][0]["target"]["path"] = "rotation";
  EXPECT_THAT(error_of(document), HasSubstr("element 1 is not of length 1"));
}

TEST(BadGltf, KeysThatAreNotInOrder) {
  GltfDocument document = moving_document();
  const std::size_t times = document.json["accessors"].size() - 2;
  const std::size_t view = document.json["accessors"][times]["bufferView"];
  const std::size_t offset = document.json["bufferViews"][view]["byteOffset"];
  document.bytes.replace(offset + 4, 4, std::string(4, '\0'));
  EXPECT_THAT(error_of(document), HasSubstr("key 1 is at 0 s after one at 0 s"));
}

}  // namespace
}  // namespace synth
