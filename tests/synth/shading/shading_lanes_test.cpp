#include "synth/shading/shading_lanes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "vo/core/random_field.h"

namespace synth {
namespace {

using Eigen::Vector3f;

constexpr int kPoints = kPacketSize - 3;  // fewer than there are lanes

/// Numbers in [-1, 1).
class Draws {
 public:
  float next() { return static_cast<float>(2 * field_.uniform(0, 0, turn_++) - 1); }
  Vector3f vector() { return {next(), next(), next()}; }

 private:
  vo::RandomField field_{1, 2, 3};
  int turn_ = 0;
};

std::vector<SurfacePoint> random_points() {
  Draws draws;
  std::vector<SurfacePoint> points(kPoints);
  for (SurfacePoint& point : points) {
    point.position = 3 * draws.vector();
    point.face_normal = draws.vector().normalized();
    point.normal = (point.face_normal + 0.2F * draws.vector()).normalized();
    point.to_viewer = (point.normal + 0.7F * draws.vector()).normalized();
    point.base_color = draws.vector().cwiseAbs();
    point.emission.setZero();
    point.metallic = std::abs(draws.next());
    point.roughness = std::abs(draws.next());
    point.specular = 1;
  }
  return points;
}

std::array<PlacedLight, 3> lights_of_each_kind() {
  std::array<PlacedLight, 3> lights;
  for (PlacedLight& light : lights) {
    light.position = {0.3F, 0.9F, -0.2F};
    light.direction = Vector3f(0.1F, -1, 0.2F).normalized();
    light.intensity = {3, 2, 1};
    light.inverse_range = 0.2F;
  }
  lights[1].kind = LightKind::directional;
  lights[2].kind = LightKind::spot;
  lights[2].cos_outer = 0.5F;
  lights[2].inverse_cone_width = 2;
  return lights;
}

LitLanes lanes_of(const std::vector<SurfacePoint>& points) {
  LitLanes lit;
  for (const SurfacePoint& point : points) {
    add_point(lit, point);
  }
  return lit;
}

TEST(ShadingLanes, GiveWhatOnePointAfterTheOtherGives) {
  const std::vector<SurfacePoint> points = random_points();
  const LitLanes lit = lanes_of(points);
  constexpr auto kBaseline = vo::InstructionSet::baseline;
  int lit_points = 0;
  for (const PlacedLight& light : lights_of_each_kind()) {
    const LightLanes lanes = direct_light(light, same_place(light), lit, kBaseline);
    Lanes3 radiance;
    add_reflected(lit, lanes, light.intensity, kBaseline, radiance);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const DirectLight direct = direct_light(light, points[i]);
      const Vector3f expected =
          reflectance(points[i], direct.to_light).cwiseProduct(direct.irradiance);
      lit_points += direct.irradiance.isZero(0) ? 0 : 1;
      EXPECT_NEAR(radiance.x[i], expected.x(), 1e-6F + 1e-5F * expected.x());
      EXPECT_NEAR(radiance.y[i], expected.y(), 1e-6F + 1e-5F * expected.y());
      EXPECT_NEAR(radiance.z[i], expected.z(), 1e-6F + 1e-5F * expected.z());
    }
    for (std::size_t i = points.size(); i < kPacketSize; ++i) {
      EXPECT_EQ(radiance.x[i], 0) << "of no point";
    }
  }
  EXPECT_GT(lit_points, kPoints / 2);
}

TEST(ShadingLanes, HaveTheSameBitsWithAllInstructionSets) {
  const vo::InstructionSet available = vo::available_instruction_set();
  if (available == vo::InstructionSet::baseline) {
    GTEST_SKIP() << "this machine has one set alone";
  }
  const LitLanes lit = lanes_of(random_points());
  for (const PlacedLight& light : lights_of_each_kind()) {
    std::array<Lanes3, 2> radiance;
    std::array<LightLanes, 2> lanes;
    std::size_t i = 0;
    for (const vo::InstructionSet set : {vo::InstructionSet::baseline, available}) {
      lanes[i] = direct_light(light, same_place(light), lit, set);
      add_reflected(lit, lanes[i], light.intensity, set, radiance[i]);
      ++i;
    }
    EXPECT_EQ(lanes[0].to_light.x, lanes[1].to_light.x);
    EXPECT_EQ(lanes[0].share, lanes[1].share);
    EXPECT_EQ(radiance[0].x, radiance[1].x);
    EXPECT_EQ(radiance[0].y, radiance[1].y);
    EXPECT_EQ(radiance[0].z, radiance[1].z);
  }
}

}  // namespace
}  // namespace synth
