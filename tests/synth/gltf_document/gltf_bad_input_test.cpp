#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "synth/gltf_document/gltf_file.h"
#include "tests/support/gltf_errors.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using nlohmann::json;
using support::TempFolder;
using testing::AllOf;
using testing::HasSubstr;

std::string error_with_buffer_uri(const std::string& uri) {
  return error_with("/buffers", {{{"uri", uri}, {"byteLength", 44}}});
}

TEST(BadGltf, MissingFile) {
  EXPECT_THAT(error_of("nowhere/scene.gltf"), HasSubstr("nowhere/scene.gltf does not exist"));
}

TEST(BadGltf, FolderInsteadOfFile) {
  const TempFolder folder;
  EXPECT_THAT(error_of(folder.path()), HasSubstr("expected a file"));
}

/// Returns the kind of the error that reading a file ends with while no file can be opened.
std::optional<vo::ErrorKind> kind_without_open_files(const std::filesystem::path& path) {
  rlimit allowed{};
  EXPECT_EQ(getrlimit(RLIMIT_NOFILE, &allowed), 0);
  const rlimit none{.rlim_cur = 0, .rlim_max = allowed.rlim_max};
  EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  std::optional<vo::ErrorKind> kind;
  try {
    read_gltf_file(path);
  } catch (const vo::Error& error) {
    kind = error.kind();
  }
  EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &allowed), 0);
  return kind;
}

TEST(BadGltf, FileThatCannotBeOpenedNowMayBeLater) {
  const TempFolder folder;
  const auto scene = folder.write("scene.gltf", triangle_document().json.dump());
  EXPECT_EQ(kind_without_open_files(scene), vo::ErrorKind::temporary);
}

TEST(BadGltf, TruncatedJson) {
  const TempFolder folder;
  const std::string text = triangle_document().json.dump();
  EXPECT_THAT(error_of(folder.write("scene.gltf", text.substr(0, text.size() / 2))),
              HasSubstr("is not a glTF file"));
}

TEST(BadGltf, NestedJson) {
  const TempFolder folder;
  const std::string deep = R"({"extras":)" + std::string(100'000, '[');
  EXPECT_THAT(error_of(folder.write("scene.gltf", deep)), HasSubstr("levels deep"));
}

TEST(BadGltf, TruncatedGlb) {
  const TempFolder folder;
  const std::string glb = triangle_document().glb();
  for (std::size_t size = 0; size < glb.size(); ++size) {
    EXPECT_NE(error_of(folder.write("scene.glb", glb.substr(0, size))), "") << size << " bytes";
  }
}

TEST(BadGltf, GlbChunkLongerThanTheFile) {
  const TempFolder folder;
  std::string glb = triangle_document().glb();
  glb[14] = 1;  // the JSON chunk's length plus 64 KiB
  EXPECT_THAT(error_of(folder.write("scene.glb", glb)), HasSubstr("chunk 0"));
}

TEST(BadGltf, GlbOfVersionOne) {
  const TempFolder folder;
  std::string glb = triangle_document().glb();
  glb[4] = 1;
  EXPECT_THAT(error_of(folder.write("scene.glb", glb)), HasSubstr("version 1, expected 2"));
}

TEST(BadGltf, DocumentOfVersionOne) {
  EXPECT_THAT(error_with("/asset/version", "1.0"), HasSubstr("asset: version is 1.0"));
}

TEST(BadGltf, MoreElementsThanMemoryIsTakenFor) {
  const TempFolder folder;
  std::string text = R"({"asset":{"version":"2.0"},"nodes":[{})";
  for (int i = 0; i < 500'000; ++i) {
    text += ",{}";
  }
  EXPECT_THAT(error_of(folder.write("scene.gltf", text + "]}")),
              HasSubstr("nodes has 500001 elements, expected at most 500000"));
}

TEST(BadGltf, MissingBuffer) {
  EXPECT_THAT(error_with_buffer_uri("other.bin"),
              AllOf(HasSubstr("buffers[0]"), HasSubstr("other.bin does not exist")));
}

TEST(BadGltf, GlbOfABufferWithoutItsChunk) {
  const TempFolder folder;
  const std::string glb = triangle_document().glb();
  std::string json_alone = glb.substr(0, glb.find("BIN") - 4);
  json_alone[8] = static_cast<char>(json_alone.size() & 0xFFU);
  json_alone[9] = static_cast<char>(json_alone.size() >> 8U);
  EXPECT_THAT(error_of(folder.write("scene.glb", json_alone)),
              HasSubstr("buffers[0]: has no uri, expected one or a binary chunk"));
}

TEST(BadGltf, BufferFileShorterThanStated) {
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.json["buffers"] = {{{"uri", "short.bin"}, {"byteLength", document.bytes.size()}}};
  folder.write("short.bin", document.bytes.substr(1));
  EXPECT_THAT(error_of(document.write(folder)), HasSubstr("41 bytes, expected 42"));
}

TEST(BadGltf, DataUriShorterThanStated) {
  EXPECT_THAT(error_with_buffer_uri("data:application/octet-stream;base64,AAAA"),
              HasSubstr("holds 3 bytes, expected 44"));
}

TEST(BadGltf, UriThatLeavesTheFolder) {
  for (const char* uri : {"../scene.bin", "%2e%2e/scene.bin", "a/../../scene.bin", "..",
                          "/etc/hostname", "%2Fetc%2Fhostname", "..\\scene.bin", "a%5C..%5Cb"}) {
    EXPECT_THAT(error_with_buffer_uri(uri),
                AllOf(HasSubstr("buffers[0]"), HasSubstr("out of the scene's folder")));
  }
}

TEST(BadGltf, UriWithAScheme) {
  for (const char* uri : {"http://host/scene.bin", "file:///etc/hostname", "C:/scene.bin"}) {
    EXPECT_THAT(error_with_buffer_uri(uri), HasSubstr("has a scheme"));
  }
}

TEST(BadGltf, SymbolicLinkOutOfTheScenesFolder) {
  const TempFolder folder;
  folder.write("outside.bin", std::string(1000, 'x'));
  GltfDocument document = triangle_document();
  document.json["buffers"] = {{{"uri", "link.bin"}, {"byteLength", document.bytes.size()}}};
  const auto scene = folder.write("scene/scene.gltf", document.json.dump());
  std::filesystem::create_symlink("../outside.bin", folder.path() / "scene/link.bin");
  EXPECT_THAT(error_of(scene),
              HasSubstr("buffers[0]: uri \"link.bin\" leads by a symbolic link out "
                        "of the scene's folder"));
  folder.write("scene/inside.bin", document.bytes);
  std::filesystem::remove(folder.path() / "scene/link.bin");
  std::filesystem::create_symlink("inside.bin", folder.path() / "scene/link.bin");
  EXPECT_EQ(error_of(scene), "");
}

TEST(BadGltf, UriThatIsNoFileName) {
  for (const char* uri : {"", "a%00b", "a%zz", "100%"}) {
    EXPECT_NE(error_with_buffer_uri(uri), "");
  }
}

TEST(BadGltf, ImageUriThatLeavesTheFolder) {
  EXPECT_THAT(error_with("/images", {{{"uri", "../image.png"}}}),
              AllOf(HasSubstr("images[0]"), HasSubstr("out of the scene's folder")));
}

TEST(BadGltf, MissingImage) {
  EXPECT_THAT(error_with("/images", {{{"uri", "image.png"}}}),
              AllOf(HasSubstr("images[0]"), HasSubstr("image.png does not exist")));
}

std::string error_with_image(const std::string& bytes) {
  const TempFolder folder;
  GltfDocument document = triangle_document();
  document.primitive()["material"] = 0;
  document.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  document.json["textures"] = {{{"source", 0}}};
  document.json["images"] = {{{"uri", "image"}}};
  folder.write("image", bytes);
  return error_of(document.write(folder));
}

std::string png_header(const std::string& width, const std::string& height) {
  return std::string("\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR", 16) + width + height;
}

TEST(BadGltf, ImageOfAnotherFormat) {
  EXPECT_THAT(error_with_image("GIF89a"), HasSubstr("images[0] (image): is of another format"));
}

TEST(BadGltf, JpegWithoutAFrame) {
  EXPECT_THAT(error_with_image("\xFF\xD8\xFF\xE0 and no more"),
              HasSubstr("images[0] (image): cannot be decoded, expected an undamaged JPEG"));
}

TEST(BadGltf, ImageWithoutTexels) {
  EXPECT_THAT(error_with_image(png_header(std::string(4, '\0'), std::string(4, '\1'))),
              HasSubstr("no texels"));
}

TEST(BadGltf, ImageOfAbsurdSize) {
  EXPECT_THAT(error_with_image(png_header(std::string(4, '\x7F'), std::string(4, '\x7F'))),
              HasSubstr("expected at most"));
}

TEST(BadGltf, DamagedImage) {
  EXPECT_THAT(error_with_image(png_header({"\0\0\0\1", 4}, {"\0\0\0\1", 4}) + "rest"),
              HasSubstr("cannot be decoded"));
}

class BadMember : public testing::TestWithParam<Replacement> {};

TEST_P(BadMember, IsNamed) {
  EXPECT_THAT(error_with(GetParam().pointer, GetParam().value), HasSubstr(GetParam().message));
}

const json kHuge = std::uint64_t{1} << 63U;

INSTANTIATE_TEST_SUITE_P(
    Index, BadMember,
    testing::Values(
        Replacement{"/scene", 1, "scene is 1, expected an index below 1"},
        Replacement{"/scenes/0/nodes", {7}, "scenes[0]: nodes[0] is 7"},
        Replacement{"/nodes/0/mesh", 1, "nodes[0]: mesh is 1"},
        Replacement{"/nodes/0/mesh", -1, "nodes[0]: mesh is -1"},
        Replacement{"/nodes/0/mesh", 0.5, "nodes[0]: mesh is 0.5"},
        Replacement{"/nodes/0/skin", 0, "skin is 0, expected none"},
        Replacement{"/nodes/0/children", {9}, "children[0] is 9"},
        Replacement{"/nodes/0/extensions", {{"KHR_lights_punctual", {{"light", 0}}}}, "light is 0"},
        Replacement{"/meshes/0/primitives/0/indices", 2, "indices is 2"},
        Replacement{"/meshes/0/primitives/0/attributes/POSITION", 77, "POSITION is 77"},
        Replacement{"/meshes/0/primitives/0/material", 0, "material is 0, expected none"},
        Replacement{"/accessors/0/bufferView", 2, "accessors[0]: bufferView is 2"},
        Replacement{"/bufferViews/1/buffer", 1, "bufferViews[1]: buffer is 1"},
        Replacement{"/textures", {{{"source", 0}}}, "textures[0]: source is 0"},
        Replacement{"/textures", {{{"sampler", 3}}}, "textures[0]: sampler is 3"},
        Replacement{"/images", {{{"bufferView", 5}}}, "images[0]: bufferView is 5"},
        Replacement{"/materials", {{{"emissiveTexture", {{"index", 0}}}}}, "index is 0"},
        Replacement{"/skins", {{{"joints", {3}}}}, "skins[0]: joints[0] is 3"}));

INSTANTIATE_TEST_SUITE_P(
    Range, BadMember,
    testing::Values(
        Replacement{"/accessors/0/count", 4, "accessors[0]: 4 elements"},
        Replacement{"/accessors/0/count", kHuge, "accessors[0]: count is 9223372036854775808"},
        Replacement{"/accessors/0/count", 0, "accessors[0]: count is 0"},
        Replacement{"/accessors/0/byteOffset", 4, "do not fit"},
        Replacement{"/accessors/0/byteOffset", kHuge, "do not fit"},
        Replacement{"/accessors/1/byteOffset", 1, "do not fit"},
        Replacement{"/accessors/0/type", "VEC5", "POSITION is of type VEC5"},
        Replacement{"/accessors/0/componentType", 5124, "components of type 5124"},
        Replacement{"/bufferViews/0/byteStride", 8, "byteStride 8"},
        Replacement{"/bufferViews/0/byteStride", 256, "byteStride is 256"},
        Replacement{"/bufferViews/0/byteLength", 43, "bufferViews[0]: spans 43 bytes"},
        Replacement{"/bufferViews/0/byteOffset", kHuge, "bufferViews[0]: spans"},
        Replacement{"/bufferViews/1/byteOffset", 35, "accessors[1]: its elements are not aligned"},
        Replacement{"/meshes/0/primitives/0/mode", 7, "mode is 7"},
        Replacement{"/meshes/0/primitives/0/indices", 0, "expected unsigned SCALAR"},
        Replacement{"/meshes/0/primitives/0/attributes/NORMAL", 1, "NORMAL is of type SCALAR"}));

INSTANTIATE_TEST_SUITE_P(
    Type, BadMember,
    testing::Values(Replacement{"/nodes", "text", "nodes is \"text\", expected an array"},
                    Replacement{"/nodes/0", 5, "nodes[0]: is 5, expected an object"},
                    Replacement{"/asset", json::array(), "asset: is an array, expected an object"},
                    Replacement{
                        "/nodes/0/translation", {1, 2}, "translation has 2 elements, expected 3"},
                    Replacement{"/nodes/0/translation", {1, 2, "x"}, "translation[2] is \"x\""},
                    Replacement{"/nodes/0/rotation", {0, 0, 0, 0}, "rotation is not of length 1"},
                    Replacement{"/nodes/0/matrix",
                                {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                                "the last row of matrix"},
                    Replacement{"/extensionsRequired", {"EXT_unknown"}, "extension EXT_unknown"},
                    Replacement{"/extensionsRequired",
                                {"KHR_texture_basisu"},
                                "npx @gltf-transform/cli ktxdecompress"}));

TEST(BadGltf, MoreMemoryThanASceneMayHave) {
  GltfDocument document = triangle_document();
  document.json["accessors"].push_back(
      {{"type", "VEC3"}, {"componentType", kFloat}, {"count", 60'000'000}});
  document.primitive() = {{"attributes", {{"POSITION", 2}}}};
  EXPECT_THAT(error_of(document), HasSubstr("bytes of memory, expected at most"));
}

TEST(BadGltf, PositionsOfIntegersWithoutTheirExtension) {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["POSITION"] =
      document.add_accessor<std::int16_t>("VEC3", kShort, 3, std::vector<std::int16_t>(12, 1));
  document.json["bufferViews"].back()["byteStride"] = 8;
  EXPECT_THAT(error_of(document), HasSubstr("POSITION has components of type 5122"));
  document.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  const TempFolder folder;
  EXPECT_EQ(error_of(document.write(folder)), "");
}

TEST(BadGltf, VertexIndexOutOfRange) {
  GltfDocument document = triangle_document();
  document.bytes[40] = 3;  // the last of three 16-bit indices
  EXPECT_THAT(
      error_of(document),
      HasSubstr("meshes[0].primitives[0]: index 2 is 3, expected one below the 3 vertices"));
}

TEST(BadGltf, PositionThatIsNotANumber) {
  GltfDocument document = triangle_document();
  document.bytes.replace(12, 4, std::string("\0\0\xC0\x7F", 4));
  EXPECT_THAT(error_of(document), HasSubstr("POSITION: element 1 is infinite or not a number"));
}

TEST(BadGltf, AttributeOfAnotherCount) {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["TEXCOORD_0"] =
      document.add_accessor<float>("VEC2", kFloat, 2, {0, 0, 1, 1});
  EXPECT_THAT(error_of(document), HasSubstr("TEXCOORD_0 has 2 elements, expected 3"));
}

TEST(BadGltf, SparseIndexOutOfRange) {
  GltfDocument document = triangle_document();
  const std::size_t indices = document.add_view<std::uint8_t>({3});
  document.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
      {"values", {{"bufferView", 0}}}};
  EXPECT_THAT(error_of(document), HasSubstr("has the sparse index 3, expected one below 3"));
}

TEST(BadGltf, CycleOfNodes) {
  EXPECT_THAT(error_with("/nodes", {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}}),
              HasSubstr("nodes[1]: is in or below a cycle"));
}

TEST(BadGltf, NodeThatIsItsOwnChild) {
  EXPECT_THAT(error_with("/nodes/0/children", {0}), HasSubstr("nodes[0]: is its own child"));
}

TEST(BadGltf, NodeWithTwoParents) {
  const json parent = {{"children", {2}}};
  EXPECT_THAT(error_with("/nodes", {parent, parent, json::object()}),
              HasSubstr("nodes[2]: is a child of nodes[0] and of nodes[1]"));
}

TEST(BadGltf, SceneOfANodeThatIsNoRoot) {
  EXPECT_THAT(error_with("/nodes", {{{"mesh", 0}}, {{"children", {0}}}}),
              HasSubstr("scenes[0]: nodes[0] is a child of nodes[1]"));
}

TEST(BadGltf, TransformThatOverflows) {
  const json scale = {{"scale", {1e200, 1e200, 1e200}}, {"children", {1}}};
  EXPECT_THAT(error_with("/nodes", {scale, {{"scale", {1e200, 1, 1}}}}),
              HasSubstr("nodes[1]: its transform overflows"));
}

TEST(BadGltf, MeshBeyondTheWorld) {
  EXPECT_THAT(error_with("/nodes/0/translation", {0, 1e19, 0}),
              HasSubstr("nodes[0]: reaches 1e+19 m from the origin, expected at most 1e+09"));
  EXPECT_THAT(error_with("/nodes/0/scale", {1e308, 1e308, 1e308}), HasSubstr("nodes[0]: reaches"));
}

}  // namespace
}  // namespace synth
