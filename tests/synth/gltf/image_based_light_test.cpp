#include "synth/gltf/image_based_light.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "synth/gltf/scene_file.h"
#include "synth/scene/srgb.h"
#include "synth/shading/environment_light.h"
#include "tests/support/gltf_errors.h"
#include "vo/geometry/equirectangular.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using support::TempFolder;
using testing::HasSubstr;

constexpr const char* kExtension = "EXT_lights_image_based";
constexpr int kFaces = 6;
constexpr int kBlocks = 4;      // along a side of a face
constexpr int kBlockSize = 32;  // px

using Face = cv::Mat_<cv::Vec4b>;  // RGBA

Face grey_face(int size, uchar value) {
  return Face(size, size, cv::Vec4b(value, value, value, 255));
}

/// A face of blocks whose colours tell the face, the column and the row.
Face block_face(int face) {
  Face image(kBlocks * kBlockSize, kBlocks * kBlockSize);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image(v, u) = {static_cast<uchar>(100 + 20 * face), static_cast<uchar>(90 + u / kBlockSize),
                     static_cast<uchar>(90 + v / kBlockSize), 255};
    }
  }
  return image;
}

std::vector<std::uint8_t> rgba_png(const Face& face) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(face.cols);
  header.height = static_cast<png_uint_32>(face.rows);
  header.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&header, nullptr, &size, 0, face.data, 0, nullptr);
  std::vector<std::uint8_t> png(size);
  png_image_write_to_memory(&header, png.data(), &size, 0, face.data, 0, nullptr);
  return png;
}

/// A triangle in a scene with a light of these faces.
GltfDocument document_with(const std::array<Face, kFaces>& faces) {
  GltfDocument document = triangle_document();
  json indices;
  for (const Face& face : faces) {
    document.json["images"].push_back(
        {{"bufferView", document.add_view(rgba_png(face))}, {"mimeType", "image/png"}});
    indices.push_back(indices.size());
  }
  document.json["extensionsUsed"] = {kExtension};
  document.json["extensions"][kExtension]["lights"] = {
      {{"specularImages", {indices}},
       {"specularImageSize", faces[0].cols},
       {"irradianceCoefficients", json(9, json::array({0, 0, 0}))}}};
  document.json["scenes"][0]["extensions"][kExtension]["light"] = 0;
  return document;
}

std::array<Face, kFaces> block_faces() {
  std::array<Face, kFaces> faces;
  for (int i = 0; i < kFaces; ++i) {
    faces[i] = block_face(i);
  }
  return faces;
}

json& light_of(GltfDocument& document) {
  return document.json["extensions"][kExtension]["lights"][0];
}

Environment environment_of(const GltfDocument& document, const GltfOptions& options = {}) {
  const TempFolder folder;
  return SceneFile(document.write(folder), options).scene().environment;
}

Vector3d light_from(const Environment& environment, const Vector3d& direction) {
  return EnvironmentLight(environment)
      .radiance(direction.normalized().cast<float>())
      .cast<double>();
}

/// OpenGL 4.6, table 8.19: the face of a direction and its place on it, 0 to 1, s to the right.
struct Texel {
  int face;
  double s, t;
};

Texel opengl_texel(const Vector3d& r) {
  const Vector3d size = r.cwiseAbs();
  const auto on = [&](int face, double sc, double tc, double ma) {
    return Texel{face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
  };
  if (size.x() >= size.y() && size.x() >= size.z()) {
    return r.x() > 0 ? on(0, -r.z(), -r.y(), size.x()) : on(1, r.z(), -r.y(), size.x());
  }
  if (size.y() >= size.z()) {
    return r.y() > 0 ? on(2, r.x(), r.z(), size.y()) : on(3, r.x(), -r.z(), size.y());
  }
  return r.z() > 0 ? on(4, r.x(), -r.y(), size.z()) : on(5, -r.x(), -r.y(), size.z());
}

/// Returns the light that block_face has at a texel whose image was flipped about its vertical
/// axis.
Vector3d block_light(const Texel& texel) {
  const auto block = [](double place) { return 90 + static_cast<int>(place * kBlocks); };
  return {decode_srgb_8bit(static_cast<uchar>(100 + 20 * texel.face)),
          decode_srgb_8bit(static_cast<uchar>(block(1 - texel.s))),
          decode_srgb_8bit(static_cast<uchar>(block(texel.t)))};
}

/// The directions of the middles of all blocks.
std::vector<Vector3d> block_directions() {
  std::vector<Vector3d> directions;
  for (int i = 0; i < kBlocks * kBlocks; ++i) {
    const double a = 2 * (i % kBlocks + 0.5) / kBlocks - 1;
    const double b = 2 * (i / kBlocks + 0.5) / kBlocks - 1;
    for (const double sign : {-1.0, 1.0}) {
      directions.insert(directions.end(), {{sign, a, b}, {a, sign, b}, {a, b, sign}});
    }
  }
  return directions;
}

TEST(ImageBasedLight, HasTheFacesWhereOpenGlsTablePutsThemFlipped) {
  const Environment environment = environment_of(document_with(block_faces()));
  for (const Vector3d& direction : block_directions()) {
    const Vector3d expected = block_light(opengl_texel(direction));
    EXPECT_LT((light_from(environment, direction) - expected).norm(), 1e-6)
        << direction.transpose();
  }
}

TEST(ImageBasedLight, TurnsByItsRotationAndGrowsByItsIntensity) {
  GltfDocument document = document_with(block_faces());
  const Eigen::Quaterniond q(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()));
  light_of(document)["rotation"] = {q.x(), q.y(), q.z(), q.w()};
  light_of(document)["intensity"] = 2.5;
  const Environment environment = environment_of(document);
  for (const Vector3d& direction : block_directions()) {
    const Vector3d expected = 2.5 * block_light(opengl_texel(direction));
    EXPECT_LT((light_from(environment, q * direction) - expected).norm(), 1e-6)
        << direction.transpose();
  }
}

TEST(ImageBasedLight, ATexelKeepsItsLightWhateverItsPlace) {
  constexpr int kSize = 64;
  for (const auto& [v, u] : {std::pair(0, 0), std::pair(31, 32), std::pair(10, 63)}) {
    std::array<Face, kFaces> faces;
    faces.fill(grey_face(kSize, 0));
    faces[2] = grey_face(kSize, 0);  // with pixels of its own
    faces[2](v, u) = {255, 255, 255, 255};
    const Environment environment = environment_of(document_with(faces));
    double sum = 0;
    for (int row = 0; row < environment.radiance.rows; ++row) {
      for (const cv::Vec3f& light : environment.radiance.row(row)) {
        sum += light[0] * vo::pixel_solid_angle(row, environment.radiance.rows);
      }
    }
    // The solid angle from the face's middle to a corner x, y of a cube of half side 1.
    const auto to_corner = [](int x, int y) {
      const double a = 2.0 * x / kSize - 1;
      const double b = 2.0 * y / kSize - 1;
      return std::atan2(a * b, std::sqrt(a * a + b * b + 1));
    };
    const double expected =
        to_corner(u + 1, v + 1) - to_corner(u, v + 1) - to_corner(u + 1, v) + to_corner(u, v);
    EXPECT_NEAR(sum, expected, 0.06 * expected) << v << ", " << u;
  }
}

TEST(ImageBasedLight, AlphaDividesLight) {
  std::array<Face, kFaces> faces;
  faces.fill(Face(4, 4, cv::Vec4b(128, 64, 32, 51)));
  const Vector3d light = light_from(environment_of(document_with(faces)), Vector3d::UnitX());
  EXPECT_NEAR(light.x(), 5 * decode_srgb_8bit(128), 1e-6);
  EXPECT_NEAR(light.z(), 5 * decode_srgb_8bit(32), 1e-6);
  faces.fill(Face(4, 4, cv::Vec4b(0, 0, 0, 0)));
  EXPECT_EQ(light_from(environment_of(document_with(faces)), Vector3d::UnitX()), Vector3d::Zero());
}

TEST(ImageBasedLight, OptionsTurnScaleAndReplaceIt) {
  const GltfDocument document = document_with(block_faces());
  const Vector3d ahead(0.25, 0.25, -1);
  const Vector3d light = light_from(environment_of(document), ahead);
  const Environment turned = environment_of(
      document, {.environment_turn = 90, .environment_strength = 3});  // -z comes to -x
  EXPECT_LT((light_from(turned, {-1, 0.25, -0.25}) - 3 * light).norm(), 1e-5);
  const Environment sky = environment_of(document, {.environment = "sky:40"});
  EXPECT_GT(light_from(sky, ahead).z(), 1000) << "cd/m^2";
}

TEST(ImageBasedLight, IsLeftOutWhereItIsNotDrawnOrNotTheScenes) {
  GltfDocument document = document_with(block_faces());
  const TempFolder folder;
  Notes notes;
  const auto path = document.write(folder);
  EXPECT_TRUE(load_gltf(path, {.needed = NeededTextures::surfaces}, &notes).environment.empty());
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("EXT_lights_image_based")));
  notes.clear();
  EXPECT_TRUE(load_gltf(path, {.needed = NeededTextures::alpha}, &notes).environment.empty());
  EXPECT_FALSE(load_gltf(path, &notes).environment.empty());
  EXPECT_THAT(notes, testing::IsEmpty());
  document.json["scenes"][0].erase("extensions");
  EXPECT_TRUE(environment_of(document).empty());
}

TEST(ImageBasedLight, FacesThatAreNoCubeAreNamed) {
  std::array<Face, kFaces> faces;
  faces.fill(grey_face(8, 100));
  faces[3] = grey_face(4, 100);
  EXPECT_THAT(error_of(document_with(faces)),
              HasSubstr("images[3]: is 4 px wide, expected 8 as the first face"));
  faces[3] = Face(4, 8, cv::Vec4b(1, 1, 1, 255));
  EXPECT_THAT(error_of(document_with(faces)), HasSubstr("images[3]: is 8 x 4 px, expected the"));
  faces[3] = Face(8, 8, cv::Vec4b(1, 1, 1, 0));
  EXPECT_THAT(error_of(document_with(faces)), HasSubstr("images[3]: has a texel that is not"));
}

TEST(ImageBasedLight, WhatIsNoLightIsNamed) {
  const std::string light = std::string("/extensions/") + kExtension + "/lights/0";
  const std::vector<std::tuple<std::string, json, const char*>> replacements = {
      {light + "/intensity", -1, "lights[0]: intensity is -1, expected 0 or more"},
      {light + "/rotation", {0, 0, 0, 2}, "lights[0]: rotation is not of length 1"},
      {light + "/specularImages/0",
       {0, 1, 2},
       "specularImages[0] is an array, expected an array of 6"},
      {light + "/specularImages/0/4", 6, "specularImages[0][4] is 6, expected an index below 6"},
      {light + "/specularImages", json::array(), "has no specularImages"},
      {light + "/irradianceCoefficients", {{1, 2, 3}}, "has 1 elements, expected 9"},
      {light + "/irradianceCoefficients/2/1", "x", "irradianceCoefficients[2][1] is \"x\""},
      {std::string("/scenes/0/extensions/") + kExtension + "/light", 1,
       "light is 1, expected an index"}};
  for (const auto& [pointer, value, message] : replacements) {
    GltfDocument document = document_with(block_faces());
    document.json[json::json_pointer(pointer)] = value;
    EXPECT_THAT(error_of(document), HasSubstr(message));
  }
}

TEST(ImageBasedLight, AFaceWhoseFileIsMissingIsNamed) {
  GltfDocument document = document_with(block_faces());
  document.json["images"][5] = {{"uri", "gone.png"}};
  const TempFolder folder;
  const auto path = document.write(folder);
  EXPECT_THAT(error_of(path), HasSubstr("gone.png does not exist"));
  EXPECT_NO_THROW(load_gltf(path, {.needed = NeededTextures::surfaces}));
}

TEST(ImageBasedLight, AFaceThatCannotBeDecodedIsNamedByItsFile) {
  GltfDocument document = document_with(block_faces());
  document.json["images"][5] = {{"uri", "bad.jpg"}};
  const TempFolder folder;
  folder.write("bad.jpg", "\xFF\xD8\xFF\xE0 and no more");
  EXPECT_THAT(error_of(document.write(folder)),
              HasSubstr("images[5] (bad.jpg): cannot be decoded, expected an undamaged JPEG"));
}

}  // namespace
}  // namespace synth
