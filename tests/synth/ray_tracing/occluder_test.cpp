#include "synth/ray_tracing/occluder.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "synth/ray_tracing/embree_scene.h"
#include "tests/support/quads.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

/// Points behind the middle of a square of two triangles, 1 m before them, and a light in front of
/// it.
struct Stage {
  Scene scene;
  WorldGeometry world;
  PlacedLight light;

  Stage() {
    add(scene, square_at(2, 0.5F), diffuse({1, 1, 1}));
    world = flatten(scene);
    light.position = (Eigen::Vector3d(0, 0, 0.5) - world.origin).cast<float>();
    light.intensity.setOnes();
  }

  ShadowPacket rays(int draw) const {
    const vo::RandomField field(7, 7, 7);
    LitLanes lit;
    for (int i = 0; i < kPacketSize; ++i) {
      SurfacePoint point;
      const Eigen::Vector3d place(4 * field.uniform(i, draw, 0) - 2,
                                  4 * field.uniform(i, draw, 1) - 2, 3);
      point.position = (place - world.origin).cast<float>();
      point.face_normal = point.normal = point.to_viewer = -Eigen::Vector3f::UnitZ();
      point.base_color.setOnes();
      add_point(lit, point);
    }
    ShadowPacket packet = shadow_rays(lit);
    constexpr auto kBaseline = vo::InstructionSet::baseline;
    aim_at_light(packet, direct_light(light, same_place(light), lit, kBaseline),
                 shadow_reach(light));
    return packet;
  }
};

TEST(Occluder, StopsNothingThatEmbreeLetsPassAndMostOfTheRest) {
  const Stage stage;
  const EmbreeScene embree(stage.world);
  int doubtless = 0;
  int stopped = 0;
  for (int draw = 0; draw < 50; ++draw) {
    const ShadowPacket start = stage.rays(draw);
    ShadowPacket traced = start;
    ShadowHit hit;
    embree.occlude(traced, hit);
    ShadowPacket left = start;
    for (const int triangle : {0, 1}) {
      Occluder(stage.world, {0, triangle})
          .stop(left, shadow_reach(stage.light), vo::available_instruction_set());
    }
    for (std::size_t i = 0; i < kPacketSize; ++i) {
      EXPECT_TRUE(left.active[i] == -1 || traced.active[i] == 0);
      doubtless += left.active[i] == 0 ? 1 : 0;
      stopped += traced.active[i] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(stopped, 100);
  EXPECT_GT(doubtless, 0.9 * stopped);
}

TEST(Occluder, HasTheSameBitsWithAllInstructionSets) {
  const Stage stage;
  ShadowPacket baseline = stage.rays(0);
  ShadowPacket available = baseline;
  const Occluder occluder(stage.world, {0, 1});
  occluder.stop(baseline, 1, vo::InstructionSet::baseline);
  occluder.stop(available, 1, vo::available_instruction_set());
  EXPECT_EQ(baseline.active, available.active);
}

TEST(Occluder, LeavesRaysThatEndBeforeIt) {
  Stage stage;
  stage.light.position.z() += 2;  // on the points' side of the square
  ShadowPacket rays = stage.rays(0);
  const LaneMask before = rays.active;
  Occluder(stage.world, {0, 0}).stop(rays, 1, vo::available_instruction_set());
  EXPECT_EQ(rays.active, before);
  EXPECT_TRUE(rays.has_rays());
}

TEST(EmbreeScene, NamesTheTriangleThatCastAShadow) {
  const Stage stage;
  const EmbreeScene embree(stage.world);
  ShadowPacket rays = stage.rays(0);
  ShadowHit hit;
  embree.occlude(rays, hit);
  EXPECT_EQ(hit.mesh, 0);
  EXPECT_TRUE(hit.triangle == 0 || hit.triangle == 1);
}

/// Sets all numbers of a packet's lanes from `first` on to NaN.
void poison(RTCRay16& rays, int first) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  for (auto* values : {&rays.org_x, &rays.org_y, &rays.org_z, &rays.dir_x, &rays.dir_y, &rays.dir_z,
                       &rays.tnear, &rays.tfar, &rays.time}) {
    std::fill(*values + first, *values + kPacketSize, kNaN);
  }
}

TEST(EmbreeScene, TracesTheRaysOfAPacketThatIsNotFull) {
  const Stage stage;
  const EmbreeScene embree(stage.world);
  for (int size = 1; size < kPacketSize; ++size) {
    HitPacket packet;
    poison(packet.lanes.ray, 0);
    const Eigen::Vector3f from = (-stage.world.origin).cast<float>();
    for (int lane = 0; lane < size; ++lane) {
      add_ray(packet, {from, Eigen::Vector3f(0.01F * static_cast<float>(lane), 0, 1)});
    }
    embree.intersect(packet, Sight::solid);
    for (int lane = 0; lane < size; ++lane) {
      EXPECT_TRUE(packet.has_hit(lane)) << size << " rays, lane " << lane;
      EXPECT_NEAR(packet.lanes.ray.tfar[lane], 2, 1e-5);
    }
  }
}

TEST(EmbreeScene, LeavesTheShadowRaysThatAreNotActive) {
  const Stage stage;
  const EmbreeScene embree(stage.world);
  ShadowPacket all = stage.rays(0);
  ShadowPacket some = all;
  for (std::size_t lane = 0; lane < kPacketSize; lane += 2) {
    some.active[lane] = 0;
    some.lanes.dir_x[lane] = std::numeric_limits<float>::quiet_NaN();
  }
  ShadowHit hit;
  embree.occlude(all, hit);
  embree.occlude(some, hit);
  for (std::size_t lane = 0; lane < kPacketSize; ++lane) {
    EXPECT_EQ(some.active[lane], lane % 2 == 0 ? 0 : all.active[lane]) << lane;
  }
}

}  // namespace
}  // namespace synth
