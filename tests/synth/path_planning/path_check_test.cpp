#include "synth/path_planning/path_check.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/box_room.h"

namespace {

using synth::FrameCheck;
using synth::PathReport;
using synth::TimedPath;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const vo::PinholeCamera kCamera = vo::PinholeCamera::from_horizontal_fov(320, 240, 60);

/// Steadily in front of the tiled wall, 1.5 m from it.
synth::TimedPath sideways(double by) {
  const synth::MoveOptions move{
      .eye = {-0.5, 0, -1}, .target = {-0.5, 0, -2.5}, .by = {by, 0, 0}, .ramp = 0};
  return {synth::dolly(move, 2), synth::sample_times(5, 2)};
}

synth::PathReport check(const synth::TimedPath& path, const synth::PathLimits& limits = {}) {
  return synth::check_path(support::box_room(), kCamera, path, limits);
}

TEST(PathCheck, MeasuresASteadyDollyPastAWall) {
  const synth::PathReport report = check(sideways(1));
  ASSERT_EQ(report.frames.size(), 11U);
  EXPECT_NEAR(report.duration, 2, 1e-12);
  EXPECT_NEAR(report.length, 1, 1e-9);
  EXPECT_EQ(report.collisions, 0);
  EXPECT_EQ(report.blank_views, 0);
  const synth::FrameCheck& frame = report.frames[5];
  EXPECT_NEAR(frame.speed, 0.5, 1e-9);
  EXPECT_NEAR(frame.turn_deg, 0, 1e-5);
  EXPECT_NEAR(frame.acceleration, 0, 1e-6);
  EXPECT_NEAR(frame.clearance, 1.5, 1e-5);
  EXPECT_EQ(frame.depth_share, 1);
  EXPECT_NEAR(frame.flow_px, kCamera.fx * 0.1 / 1.5, 1e-3) << "f v dt / Z";
}

TEST(PathCheck, MeasuresAnOrbit) {
  const synth::OrbitOptions orbit{.radius = 1, .period = 10};
  const synth::PathReport report = check({synth::orbit(orbit), {1, 1.1}});
  const double w = 2 * 3.14159265358979 / 10;  // rad/s
  EXPECT_NEAR(report.frames[0].speed, w, 1e-5);
  EXPECT_NEAR(report.frames[0].acceleration, w * w, 1e-5);
  EXPECT_NEAR(report.frames[0].turn_deg, 36, 1e-4);
}

TEST(PathCheck, FindsWhereAPathGoesThroughAWall) {
  const synth::PathReport report = check(sideways(4));
  EXPECT_EQ(report.collisions, 1);
  EXPECT_EQ(synth::range_of(report.frames, &synth::FrameCheck::clearance).min, 0);
}

/// A board that crosses the room along z at 1 m/s meets a camera at rest once.
TEST(PathCheck, FindsWhereAMovingThingRunsIntoTheCamera) {
  synth::Scene scene = support::box_room();
  const std::size_t board = scene.instances.size();
  support::add_rectangle(scene, {-0.5F, 0.5F, 0}, {1, 0, 0}, {0, -1, 0}, 0.5F);
  scene.motion.nodes.resize(2);
  scene.motion.instance_nodes.assign(scene.instances.size(), 0);
  scene.motion.instance_nodes[board] = 1;
  scene.motion.animations = {
      {.duration = 4,
       .channels = {{.node = 1,
                     .property = synth::AnimatedProperty::translation,
                     .curve = {.width = 3, .times = {0, 4}, .values = {0, 0, -2, 0, 0, 2}}}}}};
  const synth::MoveOptions move{.eye = {0, 0, 0.15}, .target = {0, 0, -2.5}};
  const synth::PathReport report =
      synth::check_path(scene, kCamera, {synth::still(move), {10, 11, 12, 13}}, {});
  EXPECT_EQ(report.collisions, 1);
  EXPECT_NEAR(report.frames[0].clearance, 1.5, 1e-5) << "the walls, the board is at -2";
  EXPECT_NEAR(report.frames[1].clearance, 1.15, 1e-5) << "the board is at -1";
  EXPECT_EQ(report.frames[2].clearance, 0) << "on its way from 0 to 1";

  const std::vector<FrameCheck> some =
      synth::check_frames(scene, kCamera, {synth::still(move), {10, 11, 12, 13}}, {1, 3});
  ASSERT_EQ(some.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(some[i].time, report.frames[i + 1].time);
    EXPECT_EQ(some[i].clearance, report.frames[i + 1].clearance) << "as of the whole path";
    EXPECT_EQ(some[i].textured_share, report.frames[i + 1].textured_share);
  }
}

TEST(PathCheck, FindsViewsThatShowNothing) {
  const synth::MoveOptions move{.eye = {0, 0, 0}, .target = {0, 0, 2.5}};
  const synth::PathReport report = check({synth::still(move), {0, 1}});
  EXPECT_EQ(report.blank_views, 2);
  EXPECT_EQ(report.frames[0].depth_share, 1);
}

TEST(PathCheck, SaysWhichLimitsAreNotKept) {
  EXPECT_THAT(check(sideways(1), {.min_clearance = 1.4, .max_speed = 0.6}).violations, IsEmpty());
  EXPECT_THAT(check(sideways(1), {.min_clearance = 1.6, .max_speed = 0.4}).violations,
              ElementsAre(HasSubstr("min_clearance: got 1.5, limit 1.6"),
                          HasSubstr("max_speed: got 0.5, limit 0.4")));
}

}  // namespace
