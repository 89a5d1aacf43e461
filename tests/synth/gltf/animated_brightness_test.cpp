#include "synth/gltf/animated_brightness.h"

#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/gltf/actors.h"
#include "synth/gltf/gltf.h"
#include "synth/scene/scene_hash.h"
#include "synth/scene/scene_motion.h"
#include "tests/support/error_text.h"
#include "tests/support/gltf_document.h"
#include "tests/support/load_document.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

/// A red point light of 8 cd on two nodes, a green sun of 3 lx, and a surface that emits (0, 2, 4).
GltfDocument shining_document() {
  GltfDocument document = triangle_document();
  document.json["extensionsUsed"] = {"KHR_animation_pointer"};
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"color", {1, 0, 0}}, {"intensity", 8}},
      {{"type", "directional"}, {"color", {0, 1, 0}}, {"intensity", 3}}};
  const auto lamp = [](int light) {
    return json{{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}};
  };
  document.json["nodes"] = {{{"mesh", 0}}, lamp(0), lamp(1), lamp(0)};
  document.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  document.primitive()["material"] = 0;
  document.json["materials"] = {
      {{"emissiveFactor", {0, 0.5, 1}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}}};
  return document;
}

/// Adds a channel with two keys, at 0 and 2 s.
void point_at(GltfDocument& document, const std::string& pointer, const std::vector<float>& values,
              const std::string& interpolation = "LINEAR") {
  const std::size_t keys = interpolation == "CUBICSPLINE" ? 6 : 2;
  const bool is_scalar = values.size() == keys;
  json& animation = document.json["animations"][0];
  animation["samplers"].push_back(
      {{"input", document.add_accessor<float>("SCALAR", kFloat, 2, {0, 2})},
       {"output", document.add_accessor(is_scalar ? "SCALAR" : "VEC3", kFloat, keys, values)},
       {"interpolation", interpolation}});
  animation["channels"].push_back(
      {{"sampler", animation["samplers"].size() - 1},
       {"target",
        {{"path", "pointer"},
         {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}});
}

const std::string kLights = "/extensions/KHR_lights_punctual/lights/";
const std::string kStrength =
    "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength";

TEST(AnimatedBrightness, DimsEachLampOfALight) {
  GltfDocument document = shining_document();
  point_at(document, kLights + "0/intensity", {8, 4});
  const Scene scene = load(document);
  EXPECT_TRUE(moves(scene));
  EXPECT_THAT(moving_instances(scene), testing::ElementsAre(false));
  const Scene later = scene_at(scene, 1);
  EXPECT_EQ(later.lights.at(0).intensity, Vector3f(6, 0, 0));
  EXPECT_EQ(later.lights.at(1).intensity, Vector3f(0, 3, 0));
  EXPECT_EQ(later.lights.at(2).intensity, Vector3f(6, 0, 0));
  EXPECT_EQ(scene_at(scene, 9).lights.at(2).intensity, Vector3f(4, 0, 0));
  EXPECT_EQ(scene.lights.at(0).intensity, Vector3f(8, 0, 0)) << "at rest";
}

TEST(AnimatedBrightness, MultipliesAnimatedColourAndStrengthInAnyOrder) {
  for (const bool color_first : {false, true}) {
    GltfDocument document = shining_document();
    for (const bool is_color : {color_first, !color_first}) {
      point_at(document, kLights + (is_color ? "1/color" : "1/intensity"),
               is_color ? std::vector<float>{0, 1, 0, 1, 0, 0.5F} : std::vector<float>{3, 5});
    }
    EXPECT_EQ(scene_at(load(document), 1).lights.at(1).intensity, Vector3f(2, 2, 1));
  }
}

TEST(AnimatedBrightness, ChangesWhatASurfaceEmits) {
  GltfDocument document = shining_document();
  point_at(document, kStrength, {4, 0}, "STEP");
  EXPECT_EQ(scene_at(load(document), 1.9).materials.at(0).emission, Vector3f(0, 2, 4));
  EXPECT_EQ(scene_at(load(document), 2).materials.at(0).emission, Vector3f(0, 0, 0));
  point_at(document, "/materials/0/emissiveFactor", {0, 0, 0, 1, 1, 1});
  EXPECT_EQ(scene_at(load(document), 1).materials.at(0).emission, Vector3f(2, 2, 2));
}

TEST(AnimatedBrightness, OfASplineThatSwingsBelowZeroIsZero) {
  GltfDocument document = shining_document();
  point_at(document, kLights + "0/intensity", {0, 0, -9, -9, 1, 0}, "CUBICSPLINE");
  EXPECT_EQ(scene_at(load(document), 0.5).lights.at(0).intensity, Vector3f(0, 0, 0));
  EXPECT_EQ(scene_at(load(document), 2).lights.at(0).intensity, Vector3f(1, 0, 0));
}

TEST(AnimatedBrightness, HasTheUnitOfTheScalesSquareButOfASun) {
  GltfDocument document = shining_document();
  point_at(document, kLights + "0/intensity", {8, 4});
  point_at(document, kLights + "1/intensity", {3, 1});
  const Scene later = scene_at(load(document, {.scale = 0.5}), 2);
  EXPECT_EQ(later.lights.at(0).intensity, Vector3f(1, 0, 0));
  EXPECT_EQ(later.lights.at(1).intensity, Vector3f(0, 1, 0));
}

TEST(AnimatedBrightness, IsPartOfTheHash) {
  GltfDocument document = shining_document();
  point_at(document, kLights + "0/intensity", {8, 4});
  const std::string dimmed = content_hash(load(document));
  GltfDocument other = shining_document();
  point_at(other, kLights + "0/intensity", {8, 5});
  EXPECT_NE(content_hash(load(other)), dimmed);
}

TEST(AnimatedBrightness, OfAConstantCurveHoldsForEver) {
  GltfDocument document = shining_document();
  point_at(document, kLights + "0/intensity", {2, 2});
  point_at(document, "/nodes/0/translation", {0, 5, 0, 0, 5, 0});
  const Scene scene = load(document);
  EXPECT_FALSE(moves(scene));
  EXPECT_EQ(scene.lights.at(0).intensity, Vector3f(2, 0, 0));
  EXPECT_EQ(scene.instances.at(0).T_world_mesh.translation(), Vector3d(0, 5, 0));
}

TEST(AnimatedBrightness, TakesTheMemoryOfEachLampsCurve) {
  GltfDocument document = shining_document();
  for (int i = 0; i < 20000; ++i) {
    document.json["nodes"].push_back(document.json["nodes"][1]);
    document.json["scenes"][0]["nodes"].push_back(4 + i);
  }
  point_at(document, kLights + "0/intensity", {8, 4});
  std::vector<float> times(10000);
  std::iota(times.begin(), times.end(), 0.0F);
  json& sampler = document.json["animations"][0]["samplers"][0];
  sampler["input"] = document.add_accessor<float>("SCALAR", kFloat, times.size(), times);
  sampler["output"] = sampler["input"];
  EXPECT_THAT(support::error_text([&] { load(document); }), HasSubstr("bytes of memory"));
}

TEST(AnimatedBrightness, LetsASurfaceBeginToShineWithItsTexture) {
  GltfDocument document = shining_document();
  document.json["materials"][0] = {{"emissiveTexture", {{"index", 0}}}};
  document.json["textures"] = {{{"source", 0}}};
  document.json["images"] = {{{"uri", "missing.png"}}};
  const GltfOptions options{.needed = NeededTextures::surfaces};
  EXPECT_EQ(support::error_text([&] { load(document, options); }), "no error");
  document.json.erase("extensionsUsed");
  point_at(document, "/materials/0/emissiveFactor", {0, 0, 0, 1, 1, 1});
  EXPECT_THAT(support::error_text([&] { load(document, options); }), HasSubstr("missing.png"));
}

TEST(AnimatedBrightness, OfAnActorIsThatOfItsOwnLampsAndSurfaces) {
  const support::TempFolder world_folder;
  const support::TempFolder folder;
  GltfDocument actor = shining_document();
  point_at(actor, kLights + "0/intensity", {8, 4});
  point_at(actor, kStrength, {4, 2});
  const GltfDocument world = shining_document();
  const LabelledScene placed = load_with_actors(
      world.write(world_folder), {},
      {{.file = actor.write(folder), .path = {Vector3d(0, 0, 0), Vector3d(1, 0, 0)}}}, nullptr);
  const Scene later = scene_at(placed.scene, 1);
  ASSERT_EQ(later.lights.size(), 6U);
  EXPECT_EQ(later.lights[0].intensity, Vector3f(8, 0, 0));
  EXPECT_EQ(later.lights[3].intensity, Vector3f(6, 0, 0));
  EXPECT_EQ(later.materials.at(0).emission, Vector3f(0, 2, 4));
  EXPECT_EQ(later.materials.at(1).emission, Vector3f(0, 1.5F, 3));
}

TEST(AnimatedBrightness, PointersMayNameNodes) {
  GltfDocument document = shining_document();
  point_at(document, "/nodes/0/translation", {0, 0, 0, 0, 2, 0});
  const Scene scene = load(document);
  EXPECT_THAT(moving_instances(scene), testing::ElementsAre(true));
  EXPECT_EQ(scene_at(scene, 1).instances.at(0).T_world_mesh.translation(), Vector3d(0, 1, 0));
}

TEST(AnimatedBrightness, NotesWhatIsNotSupported) {
  GltfDocument document = shining_document();
  point_at(document, "/materials/0/pbrMetallicRoughness/roughnessFactor", {0, 1});
  Notes notes;
  EXPECT_FALSE(moves(load(document, {}, &notes)));
  EXPECT_THAT(notes, Contains(HasSubstr("at anything but nodes, brightness")));
}

TEST(AnimatedBrightness, NamesWhatIsWrong) {
  const auto error_of = [](const std::string& pointer, const std::vector<float>& values) {
    GltfDocument document = shining_document();
    point_at(document, pointer, values);
    return support::error_text([&] { load(document); });
  };
  EXPECT_THAT(error_of(kLights + "2/intensity", {1, 1}),
              HasSubstr("names one of 2 lights, expected an index below 2"));
  EXPECT_THAT(error_of("/materials/7/emissiveFactor", {1, 1, 1, 1, 1, 1}),
              HasSubstr("expected an index below 1"));
  EXPECT_THAT(error_of(kLights + "0/intensity", {1, -1}),
              HasSubstr("output: has -1, expected brightness of 0 or more"));
  EXPECT_THAT(error_of(kLights + "0/intensity", {1, 1, 1, 1, 1, 1}), HasSubstr("expected SCALAR"));
  EXPECT_THAT(error_of(kLights + "0/color", {1, 1}), HasSubstr("expected VEC3"));
  GltfDocument twice = shining_document();
  point_at(twice, kLights + "0/intensity", {1, 2});
  point_at(twice, kLights + "0/intensity", {1, 2});
  EXPECT_THAT(support::error_text([&] { load(twice); }),
              HasSubstr("moves the intensity of lights[0] a second time"));
  GltfDocument without = shining_document();
  point_at(without, kLights + "0/intensity", {1, 2});
  without.json["animations"][0]["channels"][0]["target"].erase("extensions");
  without.json["animations"][0]["channels"][0]["target"]["node"] = 0;
  Notes notes;
  EXPECT_FALSE(moves(load(without, {}, &notes)));
  EXPECT_THAT(notes, Contains(HasSubstr("without KHR_animation_pointer")));
}

}  // namespace
}  // namespace synth
