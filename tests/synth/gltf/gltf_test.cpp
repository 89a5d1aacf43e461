#include "synth/gltf/gltf.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gltf_document.h"
#include "tests/support/load_document.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector4f;
using support::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

constexpr double kLoadRounding = 1e-12;  // m, of positions of some metres in double precision

const Mesh& only_mesh(const Scene& scene) {
  EXPECT_EQ(scene.meshes.size(), 1U);
  return scene.meshes.at(0);
}

TEST(LoadGltf, ReadsATriangle) {
  const Scene scene = load(triangle_document());
  const std::vector<Vector3d> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THAT(world_corners(scene), Pointwise(IsClose(kLoadRounding), expected));
  EXPECT_EQ(only_mesh(scene).material, kNone);
  EXPECT_TRUE(only_mesh(scene).normals.empty());
}

TEST(LoadGltf, ComposesNestedTransformsWithNegativeScale) {
  GltfDocument document = triangle_document();
  const double half = std::sqrt(0.5);
  document.json["nodes"] = {
      {{"translation", {10, 0, 0}}, {"rotation", {0, 0, half, half}}, {"children", {1}}},
      {{"translation", {0, 1, 0}}, {"scale", {-2, 1, 3}}, {"mesh", 0}}};
  // (1, 0, 0) is scaled to (-2, 0, 0), moved to (-2, 1, 0), turned by 90 degrees about z to
  // (-1, -2, 0), and moved to (9, -2, 0).
  const std::vector<Vector3d> expected = {{9, 0, 0}, {9, -2, 0}, {8, 0, 0}};
  EXPECT_THAT(world_corners(load(document)), Pointwise(IsClose(kLoadRounding), expected));
}

TEST(LoadGltf, ReadsMatricesColumnByColumn) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {
      {{"matrix", {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, -1, 0, 5, 6, 7, 1}}, {"mesh", 0}}};
  const std::vector<Vector3d> expected = {{5, 6, 7}, {5, 8, 7}, {4, 6, 7}};
  EXPECT_THAT(world_corners(load(document)), Pointwise(IsClose(kLoadRounding), expected));
}

TEST(LoadGltf, KeepsTransformsInDoublePrecision) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"translation", {1e6, 0, 0}}, {"children", {1}}},
                            {{"translation", {1e-6, 0, 0}}, {"mesh", 0}}};
  const Scene scene = load(document);
  EXPECT_EQ(scene.instances.at(0).T_world_mesh.translation().x(), 1e6 + 1e-6);
}

TEST(LoadGltf, SharesTheMeshOfTwoNodes) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}};
  document.json["scenes"][0]["nodes"] = {0, 1};
  const Scene scene = load(document);
  EXPECT_EQ(scene.meshes.size(), 1U);
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_EQ(scene.instances[1].mesh, 0);
}

TEST(LoadGltf, ReadsTheDefaultSceneOnly) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}};
  document.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  EXPECT_EQ(world_corners(load(document)).at(0).z(), 0);
  document.json["scene"] = 1;
  EXPECT_EQ(world_corners(load(document)).at(0).z(), 1);
}

TEST(LoadGltf, ReadsAllRootsWhenThereIsNoScene) {
  GltfDocument document = triangle_document();
  document.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"mesh", 0}}};
  document.json.erase("scenes");
  EXPECT_EQ(load(document).instances.size(), 2U);
}

/// A similar scene, seen from a place that is as much nearer, looks the same.
TEST(LoadGltf, ScalesTheWholeSceneWithItsLightsAndCameras) {
  constexpr double kScale = 0.001;
  GltfDocument document = triangle_document();
  document.json["nodes"][0]["translation"] = {1000, 2000, -3000};
  document.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  document.json["nodes"][0]["camera"] = 0;
  document.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 4e6}, {"range", 5000}}};
  const Scene whole = load(document);
  const Scene scene = load(document, {.scale = kScale});
  std::vector<Vector3d> expected = world_corners(whole);
  for (Vector3d& corner : expected) {
    corner *= kScale;
  }
  EXPECT_THAT(world_corners(scene), Pointwise(IsClose(kLoadRounding), expected));
  EXPECT_LT((scene.lights.at(0).position - Vector3d(1, 2, -3)).norm(), kLoadRounding);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity.x(), 4);
  EXPECT_DOUBLE_EQ(scene.lights[0].range, 5);
  EXPECT_LT((scene.cameras.at(0).T_world_camera.translation() - Vector3d(1, 2, -3)).norm(),
            kLoadRounding);
}

TEST(LoadGltf, AScaleIsAPositiveNumber) {
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(load(triangle_document(), {.scale = scale}), vo::Error) << scale;
  }
}

TEST(LoadGltf, CountsVerticesWhenThereAreNoIndices) {
  GltfDocument document = triangle_document();
  document.primitive().erase("indices");
  EXPECT_THAT(only_mesh(load(document)).triangles, ElementsAre(std::array{0, 1, 2}));
}

GltfDocument square_document(int mode) {
  GltfDocument document = triangle_document();
  document.primitive() = {
      {"attributes",
       {{"POSITION", document.add_accessor<float>("VEC3", kFloat, 5,
                                                  {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0})}}},
      {"mode", mode}};
  return document;
}

TEST(LoadGltf, TurnsEveryOtherTriangleOfAStrip) {
  EXPECT_THAT(only_mesh(load(square_document(5))).triangles,
              ElementsAre(std::array{0, 1, 2}, std::array{1, 3, 2}, std::array{2, 3, 4}));
}

TEST(LoadGltf, ReadsFansAroundTheirFirstVertex) {
  EXPECT_THAT(only_mesh(load(square_document(6))).triangles,
              ElementsAre(std::array{1, 2, 0}, std::array{2, 3, 0}, std::array{3, 4, 0}));
}

TEST(LoadGltf, LeavesOutPointsAndLinesWithANote) {
  Notes notes;
  EXPECT_TRUE(load(square_document(1), {}, &notes).meshes.empty());
  EXPECT_THAT(notes, ElementsAre(HasSubstr("points and lines"), HasSubstr("no triangles")));
}

TEST(LoadGltf, ReadsInterleavedAttributes) {
  GltfDocument document = triangle_document();
  const std::size_t view =
      document.add_view<float>({0, 0, 0, 0.1F, 0.2F, 1, 0, 0, 0.3F, 0.4F, 0, 1, 0, 0.5F, 0.6F});
  document.json["bufferViews"][view]["byteStride"] = 20;
  document.json["accessors"][0]["bufferView"] = view;
  document.json["accessors"].push_back({{"bufferView", view},
                                        {"byteOffset", 12},
                                        {"componentType", kFloat},
                                        {"type", "VEC2"},
                                        {"count", 3}});
  document.primitive()["attributes"]["TEXCOORD_0"] = 2;
  const Scene scene = load(document);
  EXPECT_EQ(world_corners(scene).at(2), Vector3d(0, 1, 0));
  EXPECT_EQ(only_mesh(scene).texcoords[0].at(1), Vector2f(0.3F, 0.4F));
}

TEST(LoadGltf, ScalesNormalisedIntegers) {
  GltfDocument document = triangle_document();
  const std::size_t colors = document.add_accessor<std::uint8_t>(
      "VEC4", kUnsignedByte, 3, {0, 51, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0});
  const std::size_t normals = document.add_accessor<std::int16_t>(
      "VEC3", kShort, 3, {0, 0, -32768, 0, 0, 0, 32767, 0, 32767, 0, 0, 0});
  document.json["bufferViews"][normals]["byteStride"] = 8;
  document.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  document.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  document.json["accessors"][colors]["normalized"] = true;
  document.json["accessors"][normals]["normalized"] = true;
  document.primitive()["attributes"]["COLOR_0"] = colors;
  document.primitive()["attributes"]["NORMAL"] = normals;
  const Scene scene = load(document);
  EXPECT_TRUE(only_mesh(scene).colors.at(0).isApprox(Vector4f(0, 0.2F, 1, 1)));
  EXPECT_EQ(only_mesh(scene).normals.at(0), Eigen::Vector3f(0, 0, -1));
}

TEST(LoadGltf, MakesColorsWithoutAlphaOpaque) {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["COLOR_0"] =
      document.add_accessor<float>("VEC3", kFloat, 3, {0, 0.5F, 1, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(only_mesh(load(document)).colors.at(0), Vector4f(0, 0.5F, 1, 1));
}

TEST(LoadGltf, NormalisesNormals) {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["NORMAL"] =
      document.add_accessor<float>("VEC3", kFloat, 3, {0, 0, 5, 0, 3, 4, 1, 0, 0});
  EXPECT_TRUE(only_mesh(load(document)).normals.at(1).isApprox(Eigen::Vector3f(0, 0.6F, 0.8F)));
}

TEST(LoadGltf, AppliesSparseValues) {
  GltfDocument document = triangle_document();
  const std::size_t indices = document.add_view<std::uint8_t>({1, 2});
  const std::size_t values = document.add_view<float>({7, 8, 9, 10, 11, 12});
  document.json["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", values}}}};
  const std::vector<Vector3d> expected = {{0, 0, 0}, {7, 8, 9}, {10, 11, 12}};
  EXPECT_THAT(world_corners(load(document)), Pointwise(IsClose(kLoadRounding), expected));
}

TEST(LoadGltf, TakesZerosWhereAnAccessorHasNoView) {
  GltfDocument document = triangle_document();
  document.json["accessors"][0].erase("bufferView");
  EXPECT_EQ(world_corners(load(document)).at(1), Vector3d(0, 0, 0));
}

TEST(LoadGltf, ReadsTheSameFromAGlb) {
  const TempFolder folder;
  const GltfDocument document = triangle_document();
  const Scene scene = load_gltf(folder.write("scene.glb", document.glb()));
  EXPECT_THAT(world_corners(scene),
              Pointwise(IsClose(kLoadRounding), world_corners(load(document))));
}

TEST(LoadGltf, ReadsBuffersFromDataUris) {
  GltfDocument document = triangle_document();
  document.json["accessors"][0].erase("bufferView");
  document.json["accessors"].erase(1);
  document.json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 3}}};
  document.json["accessors"].push_back(
      {{"bufferView", 0}, {"componentType", kUnsignedByte}, {"type", "SCALAR"}, {"count", 3}});
  document.json["buffers"] = {
      {{"uri", "data:application/octet-stream;base64,AgEA"}, {"byteLength", 3}}};
  EXPECT_THAT(only_mesh(load(document)).triangles, ElementsAre(std::array{2, 1, 0}));
}

TEST(LoadGltf, DecodesPercentAndUnicodeInUris) {
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.json["buffers"] = {
      {{"uri", "sub/a%20b%E2%9D%A4\u267B.bin"}, {"byteLength", document.bytes.size()}}};
  folder.write("sub/a b\u2764\u267B.bin", document.bytes);
  EXPECT_EQ(load_gltf(document.write(folder)).meshes.size(), 1U);
}

TEST(LoadGltf, AcceptsABufferFileThatIsLongerThanStated) {
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.json["buffers"] = {{{"uri", "long.bin"}, {"byteLength", document.bytes.size()}}};
  folder.write("long.bin", document.bytes + "more");
  EXPECT_EQ(load_gltf(document.write(folder)).meshes.size(), 1U);
}

TEST(LoadGltf, PlacesPointAndDirectionalLights) {
  GltfDocument document = triangle_document();
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 40}}, {{"type", "directional"}}};
  const auto light = [](int index) {
    return nlohmann::json{{"KHR_lights_punctual", {{"light", index}}}};
  };
  document.json["nodes"] = {
      {{"translation", {1, 2, 3}}, {"extensions", light(0)}},
      {{"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}, {"extensions", light(1)}}};
  document.json["scenes"] = {{{"nodes", {0, 1}}}};
  const Scene scene = load(document);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].position, Vector3d(1, 2, 3));
  EXPECT_EQ(scene.lights[0].intensity, Eigen::Vector3f(40, 20, 0));
  EXPECT_EQ(scene.lights[1].kind, LightKind::directional);
  EXPECT_TRUE(scene.lights[1].direction.isApprox(-Vector3d::UnitY(), kLoadRounding));
}

TEST(LoadGltf, AimsSpotLightsAlongMinusZ) {
  GltfDocument document = triangle_document();
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"range", 5},
       {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}}};
  document.json["nodes"] = {{{"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  const Light light = load(document).lights.at(0);
  EXPECT_EQ(light.kind, LightKind::spot);
  EXPECT_EQ(light.range, 5);
  EXPECT_EQ(light.inner_cone, 0.25);
  EXPECT_EQ(light.outer_cone, 0.5);
  EXPECT_TRUE(light.direction.isApprox(-Vector3d::UnitX(), kLoadRounding));
}

TEST(LoadGltf, TurnsCamerasToLookAlongTheirZ) {
  GltfDocument document = triangle_document();
  document.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  document.json["nodes"] = {
      {{"name", "eye"}, {"camera", 0}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}}};
  const SceneCamera camera = load(document).cameras.at(0);
  EXPECT_EQ(camera.name, "eye");
  EXPECT_EQ(camera.vertical_fov, 1);
  EXPECT_EQ(camera.T_world_camera.translation(), Vector3d(1, 2, 3));
  // glTF's camera looks along -z with y up.
  const Eigen::Matrix3d R_world_camera = camera.T_world_camera.rotation_matrix();
  EXPECT_TRUE(
      R_world_camera.isApprox(Vector3d(1, -1, -1).asDiagonal().toDenseMatrix(), kLoadRounding));
}

TEST(LoadGltf, NotesOptionalExtensionsOnce) {
  GltfDocument document = triangle_document();
  document.json["extensionsUsed"] = {"EXT_something", "KHR_materials_unlit"};
  Notes notes;
  load(document, {}, &notes);
  EXPECT_THAT(notes, ElementsAre("the extension EXT_something is ignored"));
}

}  // namespace
}  // namespace synth
