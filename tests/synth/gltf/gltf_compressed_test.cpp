#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "synth/gltf/gltf.h"
#include "tests/support/error_text.h"
#include "tests/support/gltf_document.h"
#include "tests/support/gltf_errors.h"
#include "tests/support/load_document.h"
#include "tests/support/temp_folder.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using support::TempFolder;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::Pointwise;

/// A wavy sheet, so that there is something to compress.
struct Sheet {
  static constexpr int kSide = 9;  // vertices
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> indices;
};

Sheet make_sheet() {
  Sheet sheet;
  for (int v = 0; v < Sheet::kSide; ++v) {
    for (int u = 0; u < Sheet::kSide; ++u) {
      const auto height = static_cast<float>((u * u + 3 * v) % 7);
      sheet.positions.emplace_back(0.5F * static_cast<float>(u), height, static_cast<float>(v));
      if (u > 0 && v > 0) {
        const auto corner = static_cast<std::uint32_t>(v * Sheet::kSide + u);
        const auto above = corner - Sheet::kSide;
        for (const std::uint32_t index :
             {above - 1, corner - 1, corner, above - 1, corner, above}) {
          sheet.indices.push_back(index);
        }
      }
    }
  }
  return sheet;
}

std::vector<Vector3d> corners_of(const Sheet& sheet) {
  std::vector<Vector3d> corners;
  for (const std::uint32_t index : sheet.indices) {
    corners.emplace_back(sheet.positions[index].cast<double>());
  }
  return corners;
}

/// Adds a view that decodes to `count` elements of `stride` bytes, from a fallback without data.
std::size_t add_compressed_view(GltfDocument& document, const std::vector<unsigned char>& bytes,
                                const std::string& mode, std::size_t count, std::size_t stride) {
  const std::size_t view = document.add_view(bytes);
  json& object = document.json["bufferViews"][view];
  const json encoded = object;
  object = {{"buffer", 1}, {"byteLength", count * stride}};
  if (mode == "ATTRIBUTES") {
    object["byteStride"] = stride;
  }
  object["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                     {"byteOffset", encoded["byteOffset"]},
                                                     {"byteLength", encoded["byteLength"]},
                                                     {"byteStride", stride},
                                                     {"count", count},
                                                     {"mode", mode}};
  return view;
}

GltfDocument meshopt_document(const Sheet& sheet) {
  const std::size_t vertices = sheet.positions.size();
  std::vector<unsigned char> positions(
      meshopt_encodeVertexBufferBound(vertices, sizeof(Eigen::Vector3f)));
  positions.resize(meshopt_encodeVertexBuffer(positions.data(), positions.size(),
                                              sheet.positions.data(), vertices,
                                              sizeof(Eigen::Vector3f)));
  std::vector<unsigned char> indices(
      meshopt_encodeIndexBufferBound(sheet.indices.size(), vertices));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), sheet.indices.data(),
                                           sheet.indices.size()));
  GltfDocument document = triangle_document();
  document.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  document.json["accessors"] = {
      {{"bufferView", add_compressed_view(document, positions, "ATTRIBUTES", vertices, 12)},
       {"type", "VEC3"},
       {"componentType", kFloat},
       {"count", vertices}},
      {{"bufferView", add_compressed_view(document, indices, "TRIANGLES", sheet.indices.size(), 4)},
       {"type", "SCALAR"},
       {"componentType", 5125},
       {"count", sheet.indices.size()}}};
  return document;
}

/// Names the document's own buffer, and a fallback that has no data.
GltfDocument with_fallback(GltfDocument document, const TempFolder& folder) {
  folder.write("scene.bin", document.bytes);
  document.json["buffers"] = {
      {{"uri", "scene.bin"}, {"byteLength", document.bytes.size()}},
      {{"byteLength", 100'000},
       {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  return document;
}

/// The codec keeps each triangle but may begin it at another corner.
std::vector<Vector3d> turned_to_first(std::vector<Vector3d> corners) {
  const auto before = [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  for (auto triangle = corners.begin(); triangle != corners.end(); triangle += 3) {
    std::rotate(triangle, std::min_element(triangle, triangle + 3, before), triangle + 3);
  }
  return corners;
}

TEST(CompressedGltf, MeshoptGivesBackWhatWasEncoded) {
  const TempFolder folder;
  const Sheet sheet = make_sheet();
  const Scene scene = load_gltf(with_fallback(meshopt_document(sheet), folder).write(folder));
  EXPECT_THAT(turned_to_first(world_corners(scene)),
              ElementsAreArray(turned_to_first(corners_of(sheet))));
}

/// Returns the positions as numbers of 24 bits with an exponent that each vertex's three share;
/// later versions of the library have other ways, too.
std::vector<std::uint32_t> exponential_of(const std::vector<Eigen::Vector3f>& positions) {
  std::vector<std::uint32_t> result(3 * positions.size());
#if MESHOPTIMIZER_VERSION >= 190
  meshopt_encodeFilterExp(result.data(), positions.size(), 12, 24, positions.front().data(),
                          meshopt_EncodeExpSharedVector);
#else
  meshopt_encodeFilterExp(result.data(), positions.size(), 12, 24, positions.front().data());
#endif
  return result;
}

TEST(CompressedGltf, MeshoptFiltersAreUndone) {
  const TempFolder folder;
  Sheet sheet = make_sheet();
  const std::vector<std::uint32_t> exponential = exponential_of(sheet.positions);
  const Sheet exact = sheet;
  std::memcpy(sheet.positions.front().data(), exponential.data(), 12 * sheet.positions.size());
  GltfDocument document = meshopt_document(sheet);
  document.json["bufferViews"][2]["extensions"]["EXT_meshopt_compression"]["filter"] =
      "EXPONENTIAL";
  const Scene scene = load_gltf(with_fallback(document, folder).write(folder));
  EXPECT_THAT(turned_to_first(world_corners(scene)),
              ElementsAreArray(turned_to_first(corners_of(exact))));
}

TEST(CompressedGltf, DamagedMeshoptDataIsNamed) {
  const TempFolder folder;
  GltfDocument document = meshopt_document(make_sheet());
  const std::size_t offset =
      document.json["bufferViews"][2]["extensions"]["EXT_meshopt_compression"]["byteOffset"];
  document.bytes[offset] = 0x11;  // no codec's header
  EXPECT_THAT(
      support::error_text([&] { load_gltf(with_fallback(document, folder).write(folder)); }),
      HasSubstr("bufferViews[2].extensions.EXT_meshopt_compression: cannot be decoded"));
}

TEST(CompressedGltf, AMeshoptViewDecodesToItsLength) {
  const TempFolder folder;
  GltfDocument document = meshopt_document(make_sheet());
  document.json["bufferViews"][3]["extensions"]["EXT_meshopt_compression"]["count"] = 3;
  EXPECT_THAT(
      support::error_text([&] { load_gltf(with_fallback(document, folder).write(folder)); }),
      HasSubstr("decodes to 3 elements of 4 bytes, expected the 1536 bytes"));
}

void fill(draco::Mesh& mesh, const Sheet& sheet) {
  mesh.set_num_points(static_cast<std::uint32_t>(sheet.positions.size()));
  draco::GeometryAttribute attribute;
  attribute.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false,
                 sizeof(Eigen::Vector3f), 0);
  const int index =
      mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(sheet.positions.size()));
  for (std::uint32_t i = 0; i < sheet.positions.size(); ++i) {
    mesh.attribute(index)->SetAttributeValue(draco::AttributeValueIndex(i),
                                             sheet.positions[i].data());
  }
  for (std::size_t i = 0; i < sheet.indices.size(); i += 3) {
    mesh.AddFace({draco::PointIndex(sheet.indices[i]), draco::PointIndex(sheet.indices[i + 1]),
                  draco::PointIndex(sheet.indices[i + 2])});
  }
}

GltfDocument draco_document(const Sheet& sheet, int method) {
  draco::Mesh mesh;
  fill(mesh, sheet);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer encoded;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &encoded).ok());
  GltfDocument document = triangle_document();
  const std::size_t view =
      document.add_view(std::vector<char>(encoded.data(), encoded.data() + encoded.size()));
  document.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  document.json["accessors"] = {
      {{"type", "VEC3"}, {"componentType", kFloat}, {"count", sheet.positions.size()}},
      {{"type", "SCALAR"}, {"componentType", 5125}, {"count", sheet.indices.size()}}};
  document.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", view}, {"attributes", {{"POSITION", mesh.attribute(0)->unique_id()}}}};
  return document;
}

bool is_before(const Vector3d& a, const Vector3d& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// The triangles as a set: Draco's edgebreaker walks the surface in its own order.
std::vector<std::vector<Vector3d>> triangle_set(const std::vector<Vector3d>& corners) {
  const std::vector<Vector3d> turned = turned_to_first(corners);
  std::vector<std::vector<Vector3d>> triangles;
  for (std::size_t i = 0; i < turned.size(); i += 3) {
    triangles.push_back({turned[i], turned[i + 1], turned[i + 2]});
  }
  std::sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_before);
  });
  return triangles;
}

class DracoGltf : public testing::TestWithParam<int> {};

TEST_P(DracoGltf, GivesBackWhatWasEncoded) {
  const Sheet sheet = make_sheet();
  EXPECT_EQ(triangle_set(world_corners(load(draco_document(sheet, GetParam())))),
            triangle_set(corners_of(sheet)));
}

TEST_P(DracoGltf, TruncatedDataIsNamed) {
  GltfDocument document = draco_document(make_sheet(), GetParam());
  for (const std::size_t length : {1U, 5U, 9U, 11U, 12U, 14U, 40U}) {
    document.json["bufferViews"][2]["byteLength"] = length;
    EXPECT_THAT(error_of(document), HasSubstr("bufferViews[2]")) << length << " bytes";
  }
}

TEST_P(DracoGltf, CountsMustBeThoseOfTheAccessors) {
  GltfDocument document = draco_document(make_sheet(), GetParam());
  document.json["accessors"][0]["count"] = 80;
  EXPECT_THAT(error_of(document), HasSubstr("decodes to 81 elements, expected the 80"));
}

TEST_P(DracoGltf, AttributesMustBeInTheData) {
  GltfDocument document = draco_document(make_sheet(), GetParam());
  document.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 7;
  EXPECT_THAT(error_of(document), HasSubstr("POSITION is attribute 7"));
}

INSTANTIATE_TEST_SUITE_P(Methods, DracoGltf,
                         testing::Values(draco::MESH_SEQUENTIAL_ENCODING,
                                         draco::MESH_EDGEBREAKER_ENCODING));

}  // namespace
}  // namespace synth
