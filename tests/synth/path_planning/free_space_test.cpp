#include "synth/path_planning/free_space.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/box_room.h"

namespace synth {
namespace {

using Eigen::Vector3d;

constexpr double kFloat = 1e-6;  // m

class BoxRoom : public testing::Test {
 protected:
  Scene scene = support::box_room();
  SurfaceTracer tracer{scene, 0.3};
  FreeSpace space{tracer};
};

TEST_F(BoxRoom, ClearanceIsTheDistanceToTheNearestWall) {
  for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(1.7, 0.3, -1), Vector3d(-0.2, -1.4, 2),
                                Vector3d(0.5, 0.25, -2.4)}) {
    EXPECT_NEAR(space.clearance(place, 10), support::distance_to_walls(place), kFloat);
  }
  EXPECT_NEAR(space.clearance({0, 0, 0}, 0.7), 0.7, kFloat) << "as far as is asked";
}

TEST_F(BoxRoom, ABallGoesAsFarAsTheWallsLetIt) {
  EXPECT_TRUE(space.is_free({-1.4, 0, 0}, {1.4, 0.3, 1}, 0.5));
  EXPECT_FALSE(space.is_free({-1.4, 0, 0}, {1.8, 0.3, 1}, 0.5));
  EXPECT_FALSE(space.is_free({0, 0, 0}, {0, 0, -4}, 0.5)) << "through the wall";
}

TEST_F(BoxRoom, AWayIsCrossedByWalls) {
  EXPECT_FALSE(space.is_crossed({-1, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(space.is_crossed({0, 0, 0}, {0, 0, -4}));
}

TEST_F(BoxRoom, LooksAlongADirection) {
  EXPECT_NEAR(space.distance_along({0.5, 0, 0}, Vector3d::UnitX()), 1.5, kFloat);
  EXPECT_EQ(space.distance_along({5, 0, 0}, Vector3d::UnitX()), 0);
}

TEST_F(BoxRoom, InsideThereAreFrontsToAllSidesAndOutsideBacks) {
  const Surroundings inside = space.look_around({0.3, 0.2, 0.1});
  EXPECT_EQ(inside.hit_share, 1);
  EXPECT_EQ(inside.level_share, 1);
  EXPECT_EQ(inside.front_share, 1);
  EXPECT_GT(inside.far_distance, 1.5);
  EXPECT_LT(inside.far_distance, 3.6) << "half of the diagonal, nearly";
  const Surroundings outside = space.look_around({4, 0.2, 0.1});
  EXPECT_GT(outside.hit_share, 0);
  EXPECT_LT(outside.hit_share, 0.5);
  EXPECT_EQ(outside.front_share, 0);
}

TEST(FreeSpace, AMirroredInstanceStillShowsItsFronts) {
  Scene scene = support::box_room();
  for (Instance& instance : scene.instances) {
    instance.T_world_mesh.linear().diagonal() << -1, 1, 1;
  }
  const SurfaceTracer tracer(scene, 0.3);
  EXPECT_EQ(FreeSpace(tracer).look_around({0.3, 0.2, 0.1}).front_share, 1);
}

/// The triangle (0, 0), (4, 0), (0, 3) in the plane z = 1, and the seven regions that a point can
/// lie over: face, edges, corners.
TEST(FreeSpace, MeasuresToFacesEdgesAndCornersOfATriangle) {
  Scene scene;
  support::add_rectangle(scene, {0, 3, 1}, {4, 0, 0}, {0, -3, 0}, 0.5F);
  scene.meshes[0].triangles.resize(1);  // corners (0, 3), (0, 0), (4, 0)
  const SurfaceTracer tracer(scene, 0.3);
  const FreeSpace space(tracer);
  EXPECT_NEAR(space.clearance({1, 1, 3}, 99), 2, kFloat);
  EXPECT_NEAR(space.clearance({2, -3, 5}, 99), 5, kFloat);
  EXPECT_NEAR(space.clearance({-3, 1, 5}, 99), 5, kFloat);
  EXPECT_NEAR(space.clearance({4, 3, 1}, 99), 12.0 / 5, kFloat);
  EXPECT_NEAR(space.clearance({-3, -4, 1}, 99), 5, kFloat);
  EXPECT_NEAR(space.clearance({7, -4, 1}, 99), 5, kFloat);
  EXPECT_NEAR(space.clearance({-3, 7, 1}, 99), 5, kFloat);
}

}  // namespace
}  // namespace synth
