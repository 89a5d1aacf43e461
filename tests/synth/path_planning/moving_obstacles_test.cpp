#include "synth/path_planning/moving_obstacles.h"

#include <gtest/gtest.h>

#include "synth/scene/scene_motion.h"
#include "synth/scene/world_geometry.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;

/// A square of 1 m across z that goes from z = -1 at 0 s to z = 1 at 2 s, before a wall at rest.
Scene passing_square() {
  Scene scene;
  add(scene, square_at(0, 0.5F), diffuse({1, 1, 1}));
  add(scene, square_at(5, 3), diffuse({1, 1, 1}));
  scene.motion.nodes.resize(2);
  scene.motion.instance_nodes = {0, 1};
  scene.motion.animations = {
      {.duration = 2,
       .channels = {{.property = AnimatedProperty::translation,
                     .curve = {.width = 3, .times = {0, 2}, .values = {0, 0, -1, 0, 0, 1}}}}}};
  return scene;
}

bool struck(double from_s, double to_s, const TimedStep& step) {
  const Scene scene = passing_square();
  return is_struck(scene_at(scene, from_s), scene_at(scene, to_s), moving_instances(scene), step);
}

TEST(IsStruck, ByWhatPassesAPointAtRest) {
  const TimedStep rest{Vector3d::Zero(), Vector3d::Zero()};
  EXPECT_TRUE(struck(0.9, 1.1, rest));
  EXPECT_FALSE(struck(0.7, 0.9, rest));
  EXPECT_FALSE(struck(1.1, 1.3, rest));
  EXPECT_FALSE(struck(0.9, 1.1, {{0.6, 0, 0}, {0.6, 0, 0}})) << "beside the square";
}

TEST(IsStruck, NotByWhatMovesAheadOfThePoint) {
  EXPECT_FALSE(struck(0.5, 1.5, {{0, 0, -0.6}, {0, 0, 0.4}}));
  EXPECT_TRUE(struck(0.5, 1.5, {{0, 0, -0.6}, {0, 0, 0.6}})) << "it overtakes the square";
}

TEST(IsStruck, NotByWhatRests) {
  EXPECT_FALSE(struck(0, 0.1, {{0, 0, 4}, {0, 0, 6}}));
}

TEST(WithTraces, HasMovingThingsWhereverTheyCome) {
  const Scene traces = with_traces(passing_square(), 1);
  EXPECT_EQ(traces.instances.size(), 2U + 4U) << "every quarter of a second";
  EXPECT_TRUE(traces.motion.animations.empty());
  const Eigen::AlignedBox3d box = visible_bounds(flatten(traces));
  EXPECT_DOUBLE_EQ(box.min().z(), -1);
  EXPECT_DOUBLE_EQ(traces.instances.back().T_world_mesh.translation().z(), 0) << "at 1 s";
}

TEST(WithTraces, OfASceneAtRestIsTheScene) {
  Scene scene;
  add(scene, square_at(5, 3), diffuse({1, 1, 1}));
  EXPECT_EQ(with_traces(scene, 10).instances.size(), 1U);
}

}  // namespace
}  // namespace synth
