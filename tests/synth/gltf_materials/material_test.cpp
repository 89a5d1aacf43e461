#include "synth/gltf_materials/material.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/gltf.h"
#include "tests/support/error_text.h"
#include "tests/support/gltf_document.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/image_files/png.h"

namespace synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;
using support::TempFolder;
using testing::Contains;
using testing::HasSubstr;

/// A triangle with texture coordinates, whose material is to be completed.
GltfDocument textured_document() {
  GltfDocument document = triangle_document();
  document.primitive()["attributes"]["TEXCOORD_0"] =
      document.add_accessor<float>("VEC2", kFloat, 3, {0, 0, 1, 0, 0, 1});
  document.primitive()["attributes"]["TEXCOORD_1"] =
      document.add_accessor<float>("VEC2", kFloat, 3, {0.5F, 0.5F, 1, 0.5F, 0.5F, 1});
  document.primitive()["material"] = 0;
  document.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  document.json["textures"] = {{{"source", 0}}};
  document.json["images"] = {{{"uri", "image.png"}}};
  return document;
}

Scene load(const GltfDocument& document, const cv::Mat& image, Notes* notes = nullptr) {
  const TempFolder folder;
  folder.write("image.png", vo::encode_png(image));
  return load_gltf(document.write(folder), notes);
}

const cv::Mat kRed = cv::Mat_<cv::Vec3b>(2, 2, cv::Vec3b(0, 0, 255));  // BGR

TEST(MaterialReader, ReadsFactorsAndUnlit) {
  GltfDocument document = triangle_document();
  document.primitive()["material"] = 1;
  document.json["materials"] = {
      {{"name", "unused"}},
      {{"pbrMetallicRoughness", {{"baseColorFactor", {0.25, 0.5, 0.75, 1}}}},
       {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}}};
  const Scene scene = load(document, kRed);
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].base_color, Vector4f(0.25F, 0.5F, 0.75F, 1));
  EXPECT_TRUE(scene.materials[0].unlit);
  EXPECT_EQ(scene.meshes.at(0).material, 0);
}

TEST(MaterialReader, MultipliesEmissionByItsStrengthAndKeepsItsTexture) {
  GltfDocument document = textured_document();
  document.json["materials"][0] = {
      {"emissiveFactor", {0.5, 1, 1}},
      {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
      {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}}};
  const Material material = load(document, kRed).materials.at(0);
  EXPECT_EQ(material.emission, Vector3f(4, 8, 8));
  EXPECT_EQ(material.emissive_texture.texture, 0);
  EXPECT_EQ(material.emissive_texture.texcoord_set, 1);
}

TEST(MaterialReader, ReadsHowStrongADielectricReflectsAndInWhichColour) {
  GltfDocument document = textured_document();
  document.json["materials"][0] = {
      {"extensions",
       {{"KHR_materials_specular",
         {{"specularFactor", 0.25},
          {"specularTexture", {{"index", 0}}},
          {"specularColorFactor", {1, 0.5, 4}},
          {"specularColorTexture", {{"index", 0}, {"texCoord", 1}}}}}}}};
  Notes notes;
  const Scene scene = load(document, kRed, &notes);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.specular, 0.25F);
  EXPECT_EQ(material.specular_color, Vector3f(1, 0.5F, 4));
  EXPECT_EQ(material.specular_color_texture.texcoord_set, 1);
  const auto encoding_of = [&](const TextureSlot& slot) {
    return scene.images.at(scene.textures.at(slot.texture).image).encoding;
  };
  EXPECT_EQ(encoding_of(material.specular_texture), TexelEncoding::linear);
  EXPECT_EQ(encoding_of(material.specular_color_texture), TexelEncoding::srgb);
  EXPECT_THAT(notes, testing::IsEmpty());
}

TEST(MaterialReader, ReadsGlassAndItsCoat) {
  GltfDocument document = textured_document();
  document.json["extensionsRequired"] = {"KHR_materials_transmission", "KHR_materials_volume",
                                         "KHR_materials_ior", "KHR_materials_clearcoat"};
  document.json["materials"][0] = {
      {"extensions",
       {{"KHR_materials_ior", {{"ior", 1.25}}},
        {"KHR_materials_transmission",
         {{"transmissionFactor", 0.75}, {"transmissionTexture", {{"index", 0}}}}},
        {"KHR_materials_volume",
         {{"thicknessFactor", 0.5},
          {"thicknessTexture", {{"index", 0}}},
          {"attenuationDistance", 2},
          {"attenuationColor", {0.25, 0.5, 1}}}},
        {"KHR_materials_clearcoat",
         {{"clearcoatFactor", 0.5},
          {"clearcoatTexture", {{"index", 0}}},
          {"clearcoatRoughnessFactor", 0.125},
          {"clearcoatRoughnessTexture",
           {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}}},
          {"clearcoatNormalTexture", {{"index", 0}, {"scale", 0.5}}}}}}}};
  Notes notes;
  const Material material = load(document, kRed, &notes).materials.at(0);
  EXPECT_EQ(material.ior, 1.25F);
  EXPECT_EQ(material.layers.transmission, 0.75F);
  EXPECT_TRUE(material.layers.is_solid);
  EXPECT_EQ(material.layers.attenuation_distance, 2);
  EXPECT_EQ(material.layers.attenuation_color, Vector3f(0.25F, 0.5F, 1));
  EXPECT_EQ(material.layers.clearcoat, 0.5F);
  EXPECT_EQ(material.layers.clearcoat_roughness, 0.125F);
  for (const TextureSlot* slot :
       {&material.layers.transmission_texture, &material.layers.clearcoat_texture,
        &material.layers.clearcoat_roughness_texture, &material.layers.clearcoat_normal_texture}) {
    EXPECT_EQ(slot->texture, 0);
  }
  EXPECT_EQ(material.layers.clearcoat_roughness_texture.T_image_texcoord.translation(),
            Vector2f(0.5F, 0.25F));
  EXPECT_EQ(material.layers.clearcoat_normal_scale, 0.5F);
  EXPECT_THAT(notes, testing::IsEmpty());
}

TEST(MaterialReader, GlassIsAThinWallThatAbsorbsNothingUnlessItSaysSo) {
  GltfDocument document = textured_document();
  document.json["materials"][0] = {{"extensions",
                                    {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                     {"KHR_materials_volume", nlohmann::json::object()}}}};
  const Material material = load(document, kRed).materials.at(0);
  EXPECT_EQ(material.ior, 1.5F);
  EXPECT_FALSE(material.layers.is_solid);
  EXPECT_TRUE(std::isinf(material.layers.attenuation_distance));
}

TEST(MaterialReader, ReadsTheSurfaceAndItsMaps) {
  GltfDocument document = textured_document();
  document.json["materials"][0] = {{"name", "brass"},
                                   {"pbrMetallicRoughness",
                                    {{"metallicFactor", 0.25},
                                     {"roughnessFactor", 0.5},
                                     {"metallicRoughnessTexture", {{"index", 0}}}}},
                                   {"normalTexture", {{"index", 0}, {"scale", 2}}},
                                   {"occlusionTexture", {{"index", 0}, {"strength", 0.75}}},
                                   {"alphaMode", "MASK"},
                                   {"alphaCutoff", 0.125},
                                   {"doubleSided", true}};
  const Scene scene = load(document, kRed);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.name, "brass");
  EXPECT_EQ(material.metallic, 0.25F);
  EXPECT_EQ(material.roughness, 0.5F);
  EXPECT_EQ(material.normal_scale, 2);
  EXPECT_EQ(material.occlusion_strength, 0.75F);
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, 0.125F);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.base_color_texture.texture, kNone);
  for (const TextureSlot* slot : {&material.metallic_roughness_texture, &material.normal_texture,
                                  &material.occlusion_texture}) {
    EXPECT_EQ(slot->texture, 0);
  }
  EXPECT_EQ(scene.images.at(0).encoding, TexelEncoding::linear);
}

TEST(MaterialReader, ReadsAnImageOnceForEachMeaningOfItsChannels) {
  GltfDocument document = textured_document();
  document.json["materials"][0]["normalTexture"] = {{"index", 0}};
  const Scene scene = load(document, kRed);
  EXPECT_EQ(scene.images.size(), 2U);
  const auto encoding_of = [&](const TextureSlot& slot) {
    return scene.images.at(scene.textures.at(slot.texture).image).encoding;
  };
  EXPECT_EQ(encoding_of(scene.materials.at(0).base_color_texture), TexelEncoding::srgb);
  EXPECT_EQ(encoding_of(scene.materials.at(0).normal_texture), TexelEncoding::linear);
}

TEST(MaterialReader, ReadsRgbImagesAsOpaqueRgba) {
  const Scene scene = load(textured_document(), kRed);
  EXPECT_EQ(scene.images.at(0).levels.size(), 2U);
  EXPECT_EQ(scene.images.at(0).levels[0](1, 1), cv::Vec4b(255, 0, 0, 255));
}

TEST(MaterialReader, ReducesSixteenBitGreyToEight) {
  const Scene scene = load(textured_document(), cv::Mat_<std::uint16_t>(1, 1, 200 * 257 + 100));
  EXPECT_EQ(scene.images.at(0).levels.at(0)(0, 0), cv::Vec4b(200, 200, 200, 255));
}

TEST(MaterialReader, ReadsImagesFromBufferViews) {
  GltfDocument document = textured_document();
  const std::string png = vo::encode_png(kRed);
  const std::size_t view = document.add_view(std::vector<char>(png.begin(), png.end()));
  document.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  EXPECT_EQ(load(document, kRed).images.at(0).levels[0].size(), cv::Size(2, 2));
}

TEST(MaterialReader, ReadsSamplers) {
  GltfDocument document = textured_document();
  document.json["samplers"] = {
      {{"magFilter", 9728}, {"minFilter", 9985}, {"wrapS", 33071}, {"wrapT", 33648}}};
  document.json["textures"][0]["sampler"] = 0;
  const Texture texture = load(document, kRed).textures.at(0);
  EXPECT_EQ(texture.magnification, TexelFilter::nearest);
  EXPECT_EQ(texture.minification, TexelFilter::linear);
  EXPECT_EQ(texture.mip, MipFilter::nearest);
  EXPECT_EQ(texture.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(texture.wrap_v, Wrap::mirrored_repeat);
}

TEST(MaterialReader, SharesImagesBetweenTextures) {
  GltfDocument document = textured_document();
  document.json["textures"].push_back({{"source", 0}});
  document.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
  document.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
  const Scene scene = load(document, kRed);
  EXPECT_EQ(scene.textures.size(), 2U);
  EXPECT_EQ(scene.images.size(), 1U);
}

TEST(MaterialReader, LeavesImagesAloneThatNoMaterialUses) {
  const TempFolder folder;
  GltfDocument document = textured_document();
  document.json["materials"][0] = {{"name", "plain"}};
  folder.write("image.png", "not an image");
  EXPECT_TRUE(load_gltf(document.write(folder)).images.empty());
}

/// A document with textures of base colour and normals whose files do not exist.
GltfDocument document_without_images() {
  GltfDocument document = textured_document();
  document.json["images"].push_back({{"uri", "normals.png"}});
  document.json["images"][0] = {{"uri", "colors.png"}};
  document.json["textures"].push_back({{"source", document.json["images"].size() - 1}});
  document.json["materials"][0]["normalTexture"] = {
      {"index", document.json["textures"].size() - 1}};
  return document;
}

TEST(MissingFiles, AreAllNamedAtOnce) {
  const TempFolder folder;
  const std::filesystem::path path = document_without_images().write(folder);
  const auto error = [&] { return support::error_text([&] { load_gltf(path); }); };
  EXPECT_THAT(error(), testing::AllOf(HasSubstr("2 files that it names do not exist"),
                                      HasSubstr("colors.png"), HasSubstr("normals.png")));
  std::filesystem::remove(folder.path() / "scene.bin");
  EXPECT_THAT(error(), testing::AllOf(HasSubstr("3 files"), HasSubstr("buffers[0]: "),
                                      HasSubstr("colors.png"), HasSubstr("normals.png")));
}

TEST(MissingFiles, MayBeThoseOfTexturesThatNothingNeeds) {
  const TempFolder folder;
  GltfDocument document = document_without_images();
  const auto load_for = [&](NeededTextures needed, Notes* notes) {
    return load_gltf(document.write(folder), {.needed = needed}, notes);
  };
  Notes notes;
  const Scene scene = load_for(NeededTextures::alpha, &notes);
  EXPECT_EQ(scene.materials.at(0).base_color_texture.texture, kNone);
  EXPECT_EQ(scene.materials.at(0).normal_texture.texture, kNone);
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("colors.png does not exist"),
                                          HasSubstr("normals.png does not exist")));
  EXPECT_THROW(load_for(NeededTextures::base_color, nullptr), vo::Error);
  document.json["materials"][0]["alphaMode"] = "MASK";
  EXPECT_THROW(load_for(NeededTextures::alpha, nullptr), vo::Error) << "its alpha shapes depth";
}

TEST(TextureSlot, ChoosesTheSetOfTexcoords) {
  GltfDocument document = textured_document();
  document.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
  const Scene scene = load(document, kRed);
  EXPECT_EQ(scene.materials.at(0).base_color_texture.texcoord_set, 1);
  EXPECT_EQ(scene.meshes.at(0).texcoords[1].at(1), Vector2f(1, 0.5F));
}

/// The example of the extension's text: the lower left quadrant of the image, turned clockwise.
TEST(TextureSlot, HoldsTheTextureTransform) {
  GltfDocument document = textured_document();
  document.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
      {"KHR_texture_transform",
       {{"offset", {0, 1}},
        {"rotation", std::numbers::pi / 2},
        {"scale", {0.5, 0.5}},
        {"texCoord", 1}}}};
  const TextureSlot slot = load(document, kRed).materials.at(0).base_color_texture;
  constexpr float kRounding = 1e-6F;
  EXPECT_EQ(slot.texcoord_set, 1);
  EXPECT_TRUE((slot.T_image_texcoord * Vector2f(0, 0)).isApprox(Vector2f(0, 1), kRounding));
  EXPECT_TRUE((slot.T_image_texcoord * Vector2f(1, 0)).isApprox(Vector2f(0, 0.5F), kRounding));
  EXPECT_TRUE((slot.T_image_texcoord * Vector2f(0, 1)).isApprox(Vector2f(0.5F, 1), kRounding));
}

}  // namespace
}  // namespace synth
