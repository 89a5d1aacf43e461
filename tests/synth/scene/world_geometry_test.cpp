#include "synth/scene/world_geometry.h"

#include <optional>

#include <gtest/gtest.h>

#include "synth/scene/scene_motion.h"
#include "tests/support/error_text.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;

constexpr double kGeometryRounding = 1e-12;  // m, of some metres in double precision

const Vector3d kAhead(0.1, 0.2, 1);

std::optional<double> depth_of_plane(const FlatMesh& mesh, const Vector3d& direction) {
  return depth_plane(mesh, 0, PlaneView{}).depth_along(direction);
}

TEST(Flatten, KeepsTheMiddleOfTheSceneNearZero) {
  Scene scene;
  add(scene, square_at(2, 1), unlit({1, 1, 1}));
  scene.instances[0].T_world_mesh = Eigen::Translation3d(1e7, 2e7, 3e7);
  const WorldGeometry world = flatten(scene);
  EXPECT_EQ(world.origin, Vector3d(1e7, 2e7, 3e7 + 2));
  EXPECT_EQ(world.meshes[0].positions[2], Eigen::Vector3f(1, 1, 0));
}

TEST(Flatten, AStrayVertexMovesNoCoordinatesAwayFromZero) {
  Scene scene;
  add(scene, square_at(2, 1), unlit({1, 1, 1}));
  scene.meshes[0].positions.emplace_back(343e3F, 40e3F, 10e3F);
  const WorldGeometry world = flatten(scene);
  EXPECT_LE(world.origin.norm(), 3);
  EXPECT_EQ((world.meshes[0].positions[2].cast<double>() + world.origin), Vector3d(1, 1, 2));
}

TEST(Flatten, NothingMovesOutOfTheWorld) {
  Scene scene;
  add(scene, square_at(2, 1), unlit({1, 1, 1}));
  SceneDuring during{.now = scene, .moments = {scene, scene}, .end = 1};
  during.moments[1].instances[0].T_world_mesh = Eigen::Translation3d(0, 0, 9e8);
  EXPECT_NO_THROW(flatten(during));
  during.moments[1].instances[0].T_world_mesh = Eigen::Translation3d(0, 0, 1e19);
  EXPECT_EQ(
      support::error_text([&] { flatten(during); }),
      "scene: instance 0, which moves: reaches 1e+19 m from the origin, expected at most 1e+09");
}

TEST(Flatten, NoLampMovesOutOfTheWorld) {
  Scene scene;
  add(scene, square_at(2, 1), diffuse({1, 1, 1}));
  scene.lights.emplace_back().position = {0, 0, 9e8};
  SceneDuring during{.now = scene, .moments = {scene, scene}, .end = 1};
  EXPECT_NO_THROW(flatten(during));
  during.moments[1].lights[0].position.y() = -1e10;
  EXPECT_EQ(support::error_text([&] { flatten(during); }),
            "scene: light 0: reaches 1e+10 m from the origin, expected at most 1e+09");
}

TEST(DepthOfPlane, IsTheClosedForm) {
  Scene scene;
  add(scene, quad({-4, -4, 1}, {8, 0, 4}, {0, 8, 0}), unlit({1, 1, 1}));  // z = 3 + x / 2
  const std::optional<double> depth = depth_of_plane(flatten(scene).meshes[0], kAhead);
  ASSERT_TRUE(depth.has_value());
  EXPECT_NEAR(*depth, 3 / (1 - 0.05), kGeometryRounding);
}

TEST(DepthOfPlane, IsUnknownOfATriangleSeenEdgeOnOrOfNoWidth) {
  Scene scene;
  add(scene, quad({0, 0, 1}, {0, 0, 1}, {0, 1, 0}), unlit({1, 1, 1}));
  add(scene, quad({0, 0, 1}, {1, 0, 1}, {2, 0, 2}), unlit({1, 1, 1}));
  const WorldGeometry world = flatten(scene);
  const Vector3d along_the_first(0, 0.2, 1);
  EXPECT_FALSE(depth_of_plane(world.meshes[1], kAhead).has_value());
  EXPECT_FALSE(depth_of_plane(world.meshes[0], along_the_first).has_value());
}

TEST(LitBounds, LeaveOutWhatIsUnlit) {
  Scene scene;
  add(scene, square_at(2, 1), diffuse({1, 1, 1}));
  add(scene, square_at(50, 90), unlit({1, 1, 1}));
  const Eigen::AlignedBox3d box = lit_bounds(flatten(scene));
  EXPECT_EQ(box.min(), Vector3d(-1, -1, 2));
  EXPECT_EQ(box.max(), Vector3d(1, 1, 2));
}

}  // namespace
}  // namespace synth
