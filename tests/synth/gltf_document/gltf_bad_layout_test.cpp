#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gltf_errors.h"

namespace synth {
namespace {

using nlohmann::json;
using support::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;

/// The triangle after a patch (RFC 7396) of its JSON.
std::string error_after(const json& patch) {
  GltfDocument document = triangle_document();
  document.json.merge_patch(patch);
  return error_of(document);
}

struct Loaded {
  Scene scene;
  Notes notes;
};

Loaded load(const GltfDocument& document) {
  const TempFolder folder;
  Loaded loaded;
  loaded.scene = load_gltf(document.write(folder), &loaded.notes);
  return loaded;
}

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xFFU);
  }
  return bytes;
}

/// The triangle's .glb with more bytes, in its stated length too.
std::string error_of_glb_with(const std::string& more) {
  std::string glb = triangle_document().glb() + more;
  glb.replace(8, 4, little_endian(static_cast<std::uint32_t>(glb.size())));
  const TempFolder folder;
  return error_of(folder.write("scene.glb", glb));
}

std::string chunk(const std::string& type, const std::string& bytes) {
  return little_endian(static_cast<std::uint32_t>(bytes.size())) + type + bytes;
}

TEST(BadLayout, ChunksOfAGlbAreThoseOfTheFormat) {
  EXPECT_EQ(error_of_glb_with(chunk("MORE", "data")), "") << "an extension's chunk";
  EXPECT_THAT(error_of_glb_with(chunk("JSON", "{}  ")),
              HasSubstr("chunk 2 of the .glb has another"));
  EXPECT_THAT(error_of_glb_with(chunk({"BIN\0", 4}, "data")),
              HasSubstr("chunk 2 of the .glb is BIN"));
  EXPECT_THAT(error_of_glb_with(chunk("MORE", "dat")),
              HasSubstr("chunk 2 of the .glb has a length"));
  EXPECT_THAT(error_of_glb_with("more"), HasSubstr("ends in the header of chunk 2"));
}

TEST(BadLayout, AStrideThatChangesWhatIsReadFitsItsViewAndIsForVertices) {
  EXPECT_THAT(error_with("/bufferViews/0/byteStride", 40), HasSubstr("at most its byteLength 36"));
  EXPECT_THAT(error_with("/bufferViews/0/byteStride", 14), HasSubstr("a multiple of 4"));
  GltfDocument document = triangle_document();
  document.json["bufferViews"][1]["byteStride"] = 4;
  document.json["accessors"][1]["count"] = 2;
  EXPECT_THAT(error_of(document), HasSubstr("indices: is in a bufferView with byteStride 4"));
  document = triangle_document();
  document.json["bufferViews"][0]["byteStride"] = 16;
  document.json["bufferViews"][0]["target"] = 34963;
  document.json["accessors"][0]["count"] = 2;
  EXPECT_THAT(error_of(document), HasSubstr("bufferViews[0]: byteStride is 16, expected none in"));
}

TEST(GoodLayout, AStrideOfAnElementsSizeIsReadWhereGltfAllowsNone) {
  const auto expected = world_corners(load(triangle_document()).scene);
  GltfDocument document = triangle_document();
  const std::size_t index = document.json["accessors"][1]["componentType"] == 5125 ? 4 : 2;
  document.json["bufferViews"][1]["byteStride"] = index;
  document.json["bufferViews"][1]["target"] = 34963;
  const Loaded loaded = load(document);
  EXPECT_EQ(world_corners(loaded.scene), expected);
  EXPECT_THAT(
      loaded.notes,
      ElementsAre("byteStrides where glTF allows none, but which change nothing, are ignored"));
}

TEST(BadLayout, AttributesInOneViewNeedAStride) {
  GltfDocument document = triangle_document();
  document.json["accessors"].push_back(document.json["accessors"][0]);
  document.primitive()["attributes"]["NORMAL"] = 2;
  EXPECT_THAT(error_of(document), HasSubstr("POSITION is in bufferViews[0] as accessors[2] is"));
  document.json["bufferViews"][0]["byteStride"] = 12;
  const TempFolder folder;
  EXPECT_EQ(error_of(document.write(folder)), "");
}

TEST(BadLayout, VerticesBeginAtMultiplesOfFourBytes) {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["COLOR_0"] =
      document.add_accessor<std::uint8_t>("VEC3", kUnsignedByte, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0});
  document.json["accessors"].back()["normalized"] = true;
  EXPECT_THAT(error_of(document), HasSubstr("COLOR_0 is not aligned"));
}

TEST(BadLayout, AViewHasBytesAndAnOffsetHasAView) {
  EXPECT_THAT(error_with("/bufferViews/1/byteLength", 0), HasSubstr("byteLength is 0"));
  EXPECT_THAT(
      error_with("/accessors/0",
                 {{"type", "VEC3"}, {"componentType", kFloat}, {"count", 3}, {"byteOffset", 0}}),
      HasSubstr("accessors[0]: has a byteOffset without bufferView"));
  EXPECT_THAT(error_with("/accessors/0/min", {0, 0}), HasSubstr("min has 2 elements, expected 3"));
}

TEST(BadLayout, WhatNothingUsesHoldsNumbersToo) {
  GltfDocument document = triangle_document();
  document.add_accessor<std::uint32_t>("SCALAR", kFloat, 2, {0, 0x7F800000});
  EXPECT_THAT(error_of(document), HasSubstr("accessors[2]: element 1 is infinite"));
}

TEST(BadLayout, SparseIndicesIncrease) {
  GltfDocument document = triangle_document();
  const std::size_t indices = document.add_view<std::uint8_t>({1, 1});
  document.json["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", 0}}}};
  EXPECT_THAT(error_of(document), HasSubstr("the sparse index 1 after one that is not smaller"));
}

TEST(BadLayout, ARotationIsAUnitQuaternion) {
  EXPECT_THAT(error_with("/nodes/0/rotation", {0, 0.75, 0, 1.8}), HasSubstr("not of length 1"));
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.json["nodes"][0]["rotation"] = {0, 0.004, 0, 1.003};
  EXPECT_EQ(error_of(document.write(folder)), "");
}

TEST(BadLayout, LightsAndCamerasMeanSomething) {
  const auto light = [](const json& members) {
    return error_after({{"extensions", {{"KHR_lights_punctual", {{"lights", {members}}}}}}});
  };
  EXPECT_THAT(light({{"type", "point"}, {"intensity", -1}}), HasSubstr("intensity is negative"));
  EXPECT_THAT(light({{"type", "point"}, {"color", {1, -1, 1}}}), HasSubstr("color is negative"));
  EXPECT_THAT(error_after({{"extensions", {{"KHR_lights_punctual", json::object()}}}}),
              HasSubstr("has no lights"));
  EXPECT_THAT(error_after({{"cameras",
                            {{{"type", "perspective"},
                              {"orthographic", json::object()},
                              {"perspective", {{"yfov", 1}, {"znear", 1}}}}}}}),
              HasSubstr("cameras[0]: has both or neither"));
}

TEST(BadLayout, SetsOfTextureCoordinatesAreFew) {
  const auto slot = [](const json& info) {
    json document = {
        {"materials",
         {{{"extensions", {{"KHR_materials_specular", {{"specularTexture", info}}}}}}}},
        {"textures", {json::object()}}};
    return error_after(document);
  };
  EXPECT_THAT(slot({{"index", 0}, {"texCoord", 3000000000U}}),
              HasSubstr("specularTexture: texCoord is 3000000000, expected at most 1000"));
  EXPECT_THAT(slot({{"index", 0},
                    {"extensions", {{"KHR_texture_transform", {{"texCoord", 4294967296U}}}}}}),
              HasSubstr("texCoord is 4294967296"));
}

TEST(BadLayout, ReferencesOfExtensionsThatAreIgnoredMustHold) {
  const auto material = [](const json& extension) {
    return error_after({{"materials", {{{"extensions", extension}}}}});
  };
  EXPECT_THAT(material({{"KHR_materials_sheen", {{"sheenColorTexture", {{"index", 0}}}}}}),
              HasSubstr("sheenColorTexture: index is 0, expected none"));
  EXPECT_THAT(material({{"KHR_materials_emissive_strength", {{"emissiveStrength", -1}}}}),
              HasSubstr("emissiveStrength is negative"));
  EXPECT_THAT(material({{"KHR_materials_specular", {{"specularFactor", 1.5}}}}),
              HasSubstr("specularFactor is 1.5, expected 0 to 1"));
  EXPECT_THAT(material({{"KHR_materials_specular", {{"specularColorFactor", {1, 1, -2}}}}}),
              HasSubstr("specularColorFactor has -2, expected 0 to 1e+06"));
  EXPECT_THAT(material({{"KHR_materials_clearcoat", {{"clearcoatNormalTexture", {{"index", 0}}}}}}),
              HasSubstr("clearcoatNormalTexture"));
  EXPECT_THAT(error_with("/meshes/0/primitives/0/extensions",
                         {{"KHR_materials_variants", {{"mappings", {{{"material", 0}}}}}}}),
              HasSubstr("material is 0, expected none"));
}

TEST(BadLayout, GlassIsPossible) {
  const auto material = [](const json& extension) {
    return error_after({{"materials", {{{"name", "pane"}, {"extensions", extension}}}}});
  };
  const auto volume = [&](const json& members) {
    return material({{"KHR_materials_volume", members}});
  };
  EXPECT_THAT(material({{"KHR_materials_ior", {{"ior", 0.9}}}}),
              HasSubstr("of \"pane\": ior is 0.9, expected 1 or more"));
  EXPECT_THAT(material({{"KHR_materials_transmission", {{"transmissionFactor", -0.5}}}}),
              HasSubstr("of \"pane\": transmissionFactor is -0.5, expected 0 to 1"));
  EXPECT_THAT(material({{"KHR_materials_clearcoat", {{"clearcoatFactor", 2}}}}),
              HasSubstr("of \"pane\": clearcoatFactor is 2, expected 0 to 1"));
  EXPECT_THAT(volume({{"thicknessFactor", -1}}),
              HasSubstr("of \"pane\": thicknessFactor is -1, expected 0 or more"));
  EXPECT_THAT(volume({{"attenuationDistance", 0}}),
              HasSubstr("of \"pane\": attenuationDistance is 0, expected a positive number"));
  EXPECT_THAT(volume({{"attenuationColor", {1, 1, 1.5}}}),
              HasSubstr("of \"pane\": attenuationColor has 1.5, expected 0 to 1"));
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.json["materials"] = {{{"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}}};
  EXPECT_EQ(error_of(document.write(folder)), "");
}

TEST(BadLayout, DataUrisAreDecodedWhetherTheyAreUsedOrNot) {
  const auto image = [](const std::string& uri) {
    return error_after({{"images", {{{"uri", uri}}}}});
  };
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.json["images"] = {{{"uri", "data:image/png;base64,AAA="}}};
  EXPECT_EQ(error_of(document.write(folder)), "");
  EXPECT_THAT(image("data:image/png;base64,A"), HasSubstr("in the middle of a byte"));
  EXPECT_THAT(image("data:image/png;base64,A`AA"), HasSubstr("has '`', expected base64"));
  EXPECT_THAT(image("data:image/png;;base64,AAAA"), HasSubstr("empty parameter"));
  EXPECT_THAT(image("data:image/png"), HasSubstr("has no comma"));
}

TEST(GoodLayout, BuffersMayBePercentEncoded) {
  GltfDocument document = triangle_document();
  std::string uri = "data:application/octet-stream,";
  for (const char c : document.bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    uri += std::string("%") + kDigits[byte / 16] + kDigits[byte % 16];
  }
  const auto expected = world_corners(load(document).scene);
  document.json["buffers"] = {{{"uri", uri}, {"byteLength", document.bytes.size()}}};
  EXPECT_EQ(world_corners(load(document).scene), expected);
}

TEST(GoodLayout, WholeNumbersMayBeWrittenAsFractions) {
  GltfDocument document = triangle_document();
  const auto expected = world_corners(load(document).scene);
  document.json["accessors"][0]["count"] = 3.0;
  document.json["nodes"][0]["mesh"] = 0.0;
  document.json["bufferViews"][0]["byteLength"] = 36.0;
  EXPECT_EQ(world_corners(load(document).scene), expected);
}

TEST(GoodLayout, WhatHasNoDataIsLeftOut) {
  GltfDocument document = triangle_document();
  document.json["buffers"] = {{{"byteLength", document.bytes.size()}}};
  const Loaded loaded = load(document);
  EXPECT_TRUE(loaded.scene.instances.empty());
  EXPECT_THAT(loaded.notes, ElementsAre("primitives whose POSITION has no data are left out",
                                        "the scene has no triangles"));
}

TEST(GoodLayout, TypesOfALaterGltfMayStandWhereNothingReadsThem) {
  GltfDocument document = triangle_document();
  document.json["accessors"].push_back(
      {{"type", "VEC5"}, {"componentType", kFloat}, {"count", 3}, {"bufferView", 0}});
  document.json["accessors"].push_back(
      {{"type", "VEC3"}, {"componentType", 5130}, {"count", 3}, {"bufferView", 0}});
  document.json["materials"] = {{{"alphaMode", "FOG"}}};
  document.primitive()["material"] = 0;
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "sphere"}}};
  document.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  const Loaded loaded = load(document);
  EXPECT_EQ(loaded.scene.instances.size(), 1U);
  EXPECT_TRUE(loaded.scene.lights.empty());
  EXPECT_THAT(loaded.notes, ElementsAre("materials of alphaMode FOG are opaque",
                                        "lights of type sphere are left out"));
}

}  // namespace
}  // namespace synth
