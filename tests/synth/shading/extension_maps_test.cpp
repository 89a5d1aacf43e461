#include <gtest/gtest.h>

#include "synth/scene/world_geometry.h"
#include "synth/shading/surface.h"
#include "tests/support/quads.h"
#include "tests/support/textures.h"

namespace synth {
namespace {

using Eigen::Vector3f;

constexpr float kFifth = 51.0F / 255;

/// Returns the point in the middle of the first triangle of a square of this material.
SurfacePoint point_of(Scene scene, const Material& material, const Vector3f& looking) {
  add(scene, square_at(1, 1), material);
  const WorldGeometry world = flatten(scene);
  return surface_point(world, {0, 0, Vector3f::Constant(1.0F / 3)}, looking, 0.01F);
}

/// A material of all extensions, with textures of 1/5, 2/5, 3/5 and 4/5 in red to alpha.
Material mapped_material(Scene& scene) {
  const cv::Vec4b texel(51, 102, 153, 204);
  Material material = diffuse({1, 1, 1});
  material.specular = 0.5F;
  material.specular_texture = plain_texture(scene, texel);
  material.specular_color = {2, 50, 1};
  material.specular_color_texture = plain_texture(scene, texel);
  material.layers.transmission = 0.5F;
  material.layers.transmission_texture = plain_texture(scene, texel);
  material.layers.clearcoat = 0.25F;
  material.layers.clearcoat_texture = plain_texture(scene, texel);
  material.layers.clearcoat_roughness = 0.75F;
  material.layers.clearcoat_roughness_texture = plain_texture(scene, texel);
  return material;
}

TEST(ExtensionMaps, ReadTheirChannelsTimesTheirFactors) {
  Scene scene;
  const Material material = mapped_material(scene);
  const SurfacePoint point = point_of(scene, material, Vector3f::UnitZ());
  EXPECT_FLOAT_EQ(point.specular, 0.5F * 4 * kFifth);
  EXPECT_FLOAT_EQ(point.normal_reflectance.x(), 0.04F * 2 * kFifth);
  EXPECT_FLOAT_EQ(point.normal_reflectance.y(), 0.04F * 50 * 2 * kFifth);
  EXPECT_FLOAT_EQ(point.normal_reflectance.z(), 0.04F * 3 * kFifth);
  EXPECT_FLOAT_EQ(point.transmission, 0.5F * kFifth);
  EXPECT_FLOAT_EQ(point.clearcoat, 0.25F * kFifth);
  EXPECT_FLOAT_EQ(point.clearcoat_roughness, 0.75F * 2 * kFifth);
}

TEST(ExtensionMaps, OfAColourReflectAtMostAll) {
  Material material = diffuse({1, 1, 1});
  material.specular_color = {100, 1, 0};
  const SurfacePoint point = point_of({}, material, Vector3f::UnitZ());
  EXPECT_EQ(point.normal_reflectance, Vector3f(1, kGlassReflectance, 0));
}

TEST(ExtensionMaps, AreFactorsAloneWhereAMeshHasNoCoordinatesForThem) {
  Scene scene;
  Material material = mapped_material(scene);
  for (TextureSlot* slot : {&material.specular_texture, &material.layers.clearcoat_texture,
                            &material.layers.transmission_texture}) {
    slot->texcoord_set = 1;
  }
  const SurfacePoint point = point_of(scene, material, Vector3f::UnitZ());
  EXPECT_EQ(point.specular, 0.5F);
  EXPECT_EQ(point.clearcoat, 0.25F);
  EXPECT_EQ(point.transmission, 0.5F);
}

TEST(ExtensionMaps, ACoatIsSmoothOverANormalMapUnlessItHasItsOwn) {
  const cv::Vec4b tilted(204, 128, 230, 255);
  Scene scene;
  Material material = diffuse({1, 1, 1});
  material.normal_texture = plain_texture(scene, tilted);
  material.layers.clearcoat = 1;
  const SurfacePoint smooth = point_of(scene, material, Vector3f::UnitZ());
  EXPECT_EQ(smooth.coat_normal, smooth.face_normal);
  EXPECT_LT(smooth.normal.dot(smooth.face_normal), 0.9F);
  material.layers.clearcoat_normal_texture = plain_texture(scene, tilted);
  for (const Vector3f& looking : {Vector3f(0, 0, 1), Vector3f(0, 0, -1)}) {
    const SurfacePoint mapped = point_of(scene, material, looking);
    EXPECT_EQ(mapped.coat_normal, mapped.normal);
  }
  material.layers.clearcoat_normal_scale = 0;
  EXPECT_TRUE(
      point_of(scene, material, Vector3f::UnitZ()).coat_normal.isApprox(smooth.face_normal, 1e-6F));
}

}  // namespace
}  // namespace synth
