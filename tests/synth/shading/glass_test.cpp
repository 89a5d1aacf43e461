#include "synth/shading/glass.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "synth/shading/layers.h"
#include "synth/shading/shading.h"

namespace synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kDeg = std::numbers::pi / 180;

/// Returns Fresnel's reflectance by the angles on both sides, rad.
double reflectance_by_angles(double before, double behind) {
  const double across = std::sin(before - behind) / std::sin(before + behind);
  const double along = std::tan(before - behind) / std::tan(before + behind);
  return (across * across + along * along) / 2;
}

TEST(Fresnel, IsTheFormOfSinesAndTangents) {
  for (const double ior : {1.1, 1.33, 1.5, 2.4, 1 / 1.5}) {
    for (const double angle : {5.0, 20.0, 35.0, 60.0, 75.0, 88.0}) {
      const double sine = std::sin(angle * kDeg) / ior;
      const double expected = sine < 1 ? reflectance_by_angles(angle * kDeg, std::asin(sine)) : 1;
      EXPECT_NEAR(
          fresnel_reflectance(static_cast<float>(std::cos(angle * kDeg)), static_cast<float>(ior)),
          expected, 2e-6)
          << ior << " at " << angle;
    }
  }
}

TEST(Fresnel, StraightOnAndAtBrewstersAngleIsTheClosedForm) {
  constexpr double kIor = 1.5;
  EXPECT_NEAR(fresnel_reflectance(1, kIor), 0.04, 1e-7);
  EXPECT_FLOAT_EQ(normal_reflectance(kIor), 0.04F);
  EXPECT_EQ(normal_reflectance(0), 1);
  const double across = (kIor * kIor - 1) / (kIor * kIor + 1);  // nothing is reflected along
  EXPECT_NEAR(fresnel_reflectance(static_cast<float>(std::cos(std::atan(kIor))), kIor),
              across * across / 2, 1e-6);
}

TEST(Refracted, FollowsSnellsLawInThePlaneOfIncidence) {
  for (const float ratio : {1.5F, 1 / 1.5F, 1.0F}) {
    const double angle = 30 * kDeg;
    const Vector3f to_viewer(static_cast<float>(std::sin(angle)), 0,
                             static_cast<float>(std::cos(angle)));
    const std::optional<Vector3f> direction = refracted(to_viewer, Vector3f::UnitZ(), ratio);
    ASSERT_TRUE(direction);
    EXPECT_NEAR(direction->x(), -std::sin(angle) / ratio, 1e-6);
    EXPECT_EQ(direction->y(), 0);
    EXPECT_NEAR(direction->norm(), 1, 1e-6);
    EXPECT_LT(direction->z(), 0);
  }
}

TEST(Refracted, EndsAtTheCriticalAngle) {
  const auto towards = [](double angle) {
    return Vector3f(static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle)));
  };
  const double critical = std::asin(1 / 1.5);
  EXPECT_TRUE(refracted(towards(critical - 1e-3), Vector3f::UnitZ(), 1 / 1.5F));
  EXPECT_FALSE(refracted(towards(critical + 1e-3), Vector3f::UnitZ(), 1 / 1.5F));
}

TEST(Transmittance, IsAnExponentialOfTheLength) {
  MaterialLayers layers;
  EXPECT_EQ(transmittance(layers, 1e9F), Vector3f(1, 1, 1));
  layers.attenuation_color = {0.25F, 0.5F, 1};
  layers.attenuation_distance = 0.5F;
  for (const double length : {0.0, 0.1, 0.5, 2.0}) {
    const Vector3f actual = transmittance(layers, static_cast<float>(length));
    EXPECT_NEAR(actual.x(), std::exp(std::log(0.25) / 0.5 * length), 1e-6);
    EXPECT_NEAR(actual.y(), std::exp(std::log(0.5) / 0.5 * length), 1e-6);
    EXPECT_EQ(actual.z(), 1);
  }
}

SurfacePoint glass_point(float roughness) {
  SurfacePoint point;
  point.position.setZero();
  point.normal = point.face_normal = point.coat_normal = Vector3f::UnitZ();
  point.to_viewer = Vector3f(0.6F, 0, 0.8F);
  point.base_color.setOnes();
  point.emission.setZero();
  point.roughness = roughness;
  point.specular = 1;
  return point;
}

/// Returns the mean weight of the reflected and of the transmitted directions, each of which is 0
/// for the other's.
std::array<double, 2> shares_of(const SurfacePoint& point, const Material& material) {
  constexpr int kSteps = 64;
  std::array<double, 2> sums{};
  for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
    const auto part = [i](int by) {
      return (static_cast<float>(i / by % kSteps) + 0.5F) / static_cast<float>(kSteps);
    };
    const GlassScattered scattered =
        scatter_at_glass(point, material, part(1), Vector2f(part(kSteps), part(kSteps * kSteps)));
    EXPECT_NEAR(scattered.direction.norm(), 1, 1e-5);
    sums[scattered.is_reflected ? 0 : 1] += scattered.weight.y();
  }
  return {sums[0] / std::pow(kSteps, 3), sums[1] / std::pow(kSteps, 3)};
}

TEST(Glass, ReflectsAndTransmitsByFresnelsShares) {
  Material glass;
  glass.layers.transmission = 1;
  for (const bool is_solid : {false, true}) {
    glass.layers.is_solid = is_solid;
    const std::array<double, 2> shares = shares_of(glass_point(0), glass);
    const double expected = fresnel_reflectance(0.8F, 1.5F);
    EXPECT_NEAR(shares[0], expected, 1.0 / 64);
    EXPECT_EQ(shares[0] + shares[1], 1);
  }
  glass.ior = 0;
  EXPECT_EQ(shares_of(glass_point(0), glass)[0], 1);
}

TEST(Glass, ThatIsRoughLosesLittleAndSpreadsAboutTheSmoothDirections) {
  Material glass;
  glass.layers.transmission = 1;
  for (const bool is_solid : {false, true}) {
    glass.layers.is_solid = is_solid;
    const std::array<double, 2> smooth = shares_of(glass_point(0), glass);
    const std::array<double, 2> rough = shares_of(glass_point(0.3F), glass);
    EXPECT_NEAR(rough[0], smooth[0], 0.02);
    EXPECT_NEAR(rough[0] + rough[1], 1, 0.02);
    EXPECT_LT(rough[0] + rough[1], 1);
  }
  const GlassScattered middle = scatter_at_glass(glass_point(0.1F), glass, 0.9F, Vector2f::Zero());
  EXPECT_NEAR(middle.direction.x(), -0.4, 0.01);
}

/// Returns the mean of a surface's layers over all choices, towards a light.
Vector3d mean_of_layers(const SurfacePoint& whole, const Vector3f& to_light) {
  constexpr int kChoices = 20000;
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < kChoices; ++i) {
    SurfacePoint point = whole;
    const ChosenLayer chosen =
        choose_layer(false, (static_cast<float>(i) + 0.5F) / kChoices, point);
    if (!chosen.is_glass) {
      sum += (chosen.weight * reflectance(point, to_light)).cast<double>() / kChoices;
    }
  }
  return sum;
}

TEST(Layers, OfACoatSumUpToTheSpecificationsFormula) {
  SurfacePoint point = glass_point(0.6F);
  point.clearcoat = 0.7F;
  point.clearcoat_roughness = 0.5F;
  point.base_color = {0.2F, 0.4F, 0.8F};
  point.metallic = 0.3F;
  const Vector3f to_light = Vector3f(-0.2F, 0.3F, 0.9F).normalized();
  SurfacePoint gloss = glass_point(0.5F);
  gloss.base_color.setZero();
  const double fresnel = 0.04 + 0.96 * std::pow(1 - 0.8, 5);
  const Vector3d expected = (1 - 0.7 * fresnel) * reflectance(point, to_light).cast<double>() +
                            0.7 * reflectance(gloss, to_light).cast<double>();
  EXPECT_TRUE(mean_of_layers(point, to_light).isApprox(expected, 1e-3));
}

TEST(Layers, OfPartlyTransmittingGlassLeaveTheRestOfTheDiffuseLight) {
  SurfacePoint point = glass_point(0.6F);
  point.transmission = 0.25F;
  point.specular = 0;
  const Vector3f to_light = Vector3f(-0.2F, 0.3F, 0.9F).normalized();
  EXPECT_NEAR(mean_of_layers(point, to_light).y(), 0.75 / std::numbers::pi, 1e-4);
  point.metallic = 1;  // of which nothing is glass
  EXPECT_NEAR(mean_of_layers(point, to_light).y(), reflectance(point, to_light).y(), 1e-4);
}

TEST(ClearWall, LetsStraightOnWhatPathsDoOnAverage) {
  Material material;
  material.roughness = 0;
  material.layers.transmission = 0.7F;
  material.layers.clearcoat = 0.5F;
  ASSERT_TRUE(is_clear_wall(material));
  SurfacePoint pane = glass_point(0);
  pane.base_color = {0.9F, 0.5F, 0.2F};
  pane.metallic = 0.2F;
  pane.transmission = material.layers.transmission;
  pane.clearcoat = material.layers.clearcoat;
  constexpr int kChoices = 1000;
  Vector3d mean = Vector3d::Zero();
  for (int i = 0; i < kChoices; ++i) {
    for (int j = 0; j < kChoices; ++j) {
      SurfacePoint point = pane;
      const ChosenLayer layer =
          choose_layer(false, (static_cast<float>(i) + 0.5F) / kChoices, point);
      if (!layer.is_glass) {
        break;
      }
      const GlassScattered scattered = scatter_at_glass(
          point, material, (static_cast<float>(j) + 0.5F) / kChoices, Vector2f(0.5F, 0.5F));
      if (!scattered.is_reflected) {
        ASSERT_EQ(scattered.direction, -point.to_viewer);
        mean += (layer.weight * scattered.weight).cast<double>() / kChoices / kChoices;
      }
    }
  }
  const Vector3f share = straight_share(pane, material);
  EXPECT_LT((mean - share.cast<double>()).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_GT(share.x(), 0.4);
}

TEST(ClearWall, IsNoSolidAndNothingRoughOrOpaque) {
  Material material;
  material.roughness = 0;
  EXPECT_FALSE(is_clear_wall(material));
  material.layers.transmission = 0.5F;
  EXPECT_TRUE(is_clear_wall(material));
  material.roughness = 0.2F;
  EXPECT_FALSE(is_clear_wall(material));
  material.roughness = 0;
  material.layers.is_solid = true;
  EXPECT_FALSE(is_clear_wall(material));
}

}  // namespace
}  // namespace synth
