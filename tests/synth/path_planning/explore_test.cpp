#include "synth/path_planning/explore.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/path_planning/view_content.h"
#include "tests/support/box_room.h"
#include "tests/support/error_text.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr ExploreOptions kOptions{
    .length = 5, .speed = 0.8, .clearance = 0.4, .turn_deg = 45, .seed = 3};

class Exploration : public testing::Test {
 protected:
  Scene scene = support::box_room();
  SurfaceTracer tracer{scene, 0.3};
};

TEST_F(Exploration, KeepsItsClearanceSpeedAndTurningAllAlong) {
  const ExploredPath found = explore(tracer, 0, kOptions);
  constexpr double kDifference = 0.01;  // s
  constexpr double kRounding = 1e-6;
  for (double time = 0; time < found.duration; time += kDifference) {
    const vo::SE3 here = found.path(time);
    const vo::SE3 next = found.path(time + kDifference);
    EXPECT_GE(support::distance_to_walls(here.translation()), 0.4 - kRounding);
    EXPECT_LE((next.translation() - here.translation()).norm(), 0.8 * kDifference + kRounding);
    EXPECT_LE((here.inverse() * next).angle() * 180 / std::numbers::pi,
              45 * kDifference + kRounding);
    EXPECT_NEAR((here.rotation() * Vector3d::UnitX()).y(), 0, kRounding) << "it never rolls";
  }
}

TEST_F(Exploration, GoesAsFarAsItIsAskedAndNoFarther) {
  const ExploredPath found = explore(tracer, 0, kOptions);
  const double length = vo::path_length(sample(found.path, 100, found.duration));
  EXPECT_LE(length, 5);
  EXPECT_GT(length, 4);
  const ExploredPath timed = explore(tracer, 6, {.speed = 0.8, .clearance = 0.4, .seed = 3});
  EXPECT_LE(timed.duration, 6);
  EXPECT_GT(timed.duration, 5.5);
}

TEST_F(Exploration, IsAFunctionOfItsSeed) {
  const Vector3d place = explore(tracer, 0, kOptions).path(2).translation();
  EXPECT_EQ(explore(tracer, 0, kOptions).path(2).translation(), place);
  ExploreOptions other = kOptions;
  other.seed = 4;
  EXPECT_GT((explore(tracer, 0, other).path(2).translation() - place).norm(), 0.01);
}

/// One wall of six has something to see.
TEST_F(Exploration, LooksWhereThereIsTexture) {
  const ExploredPath found = explore(tracer, 0, kOptions);
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(32, 24, 60);
  for (double time = 0; time < found.duration; time += 0.5) {
    EXPECT_GT(view_content(tracer, camera, found.path(time), 99).textured_share, 0.2)
        << "at " << time << " s";
  }
}

TEST_F(Exploration, StaysInsideThoughThereIsASkyAround) {
  const std::size_t walls = scene.instances.size();
  for (std::size_t i = 0; i < walls; ++i) {  // the same room, fifteen times as large
    Instance sky = scene.instances[i];
    sky.T_world_mesh.linear() *= 15;
    scene.instances.push_back(sky);
  }
  const SurfaceTracer under_the_sky(scene, 0.3);
  ExploreOptions small = kOptions;
  small.clearance = 0.2;
  const ExploredPath found = explore(under_the_sky, 0, small);
  for (double time = 0; time < found.duration; time += 0.5) {
    EXPECT_GT(support::distance_to_walls(found.path(time).translation()), 0);
  }
}

TEST_F(Exploration, ChoosesByTheScenesScaleWhatIsNotGiven) {
  const ExploredPath found = explore(tracer, 8, {});
  Scene giant = support::box_room();
  for (Instance& instance : giant.instances) {
    instance.T_world_mesh.linear() *= 128;
  }
  const SurfaceTracer giant_tracer(giant, 0.3);
  const ExploredPath large = explore(giant_tracer, 8, {});
  EXPECT_NEAR(large.speed, 128 * found.speed, 128e-5);
  EXPECT_NEAR(large.clearance, 128 * found.clearance, 128e-5);
  EXPECT_LT((large.path(4).translation() - 128 * found.path(4).translation()).norm(), 128e-4);
}

TEST_F(Exploration, TurnsAsSlowlyOrAsFastAsACameraCan) {
  ExploreOptions options = kOptions;
  options.turn_deg = 0.01;
  const ExploredPath slow = explore(tracer, 0, options);
  const double turned = (slow.path(0).inverse() * slow.path(4)).angle();
  EXPECT_LE(turned, 4 * 0.01 * std::numbers::pi / 180 + 1e-9);
  for (const double turn_deg : {0.0, 1e-300, 1e300, std::nan("")}) {
    options.turn_deg = turn_deg;
    EXPECT_THAT(support::error_text([&] { explore(tracer, 0, options); }),
                HasSubstr("explore.turn_deg: expected from 0.01 to 10000 deg/s, got "));
  }
}

TEST_F(Exploration, WithoutRoomThereIsAnError) {
  ExploreOptions wide = kOptions;
  wide.clearance = 1.6;
  EXPECT_THAT(support::error_text([&] { explore(tracer, 0, wide); }),
              HasSubstr("explore: found no free space with a clearance of 1.6 m"));
  EXPECT_THAT(support::error_text([&] { explore(tracer, 0, {.speed = -1}); }),
              HasSubstr("explore.speed: expected 0 or above, got -1"));
}

}  // namespace
}  // namespace synth
