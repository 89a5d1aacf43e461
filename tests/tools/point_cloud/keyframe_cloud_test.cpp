#include "tools/point_cloud/keyframe_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/plane_frames.h"
#include "tests/support/sideways_walk.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/tracking/tracker.h"

namespace {

using support::sideways_walk;
using support::small_camera;
using tools::CloudPoint;
using tools::KeyframeCloud;
using vo::SE3;

/// The share of points that are farther than a distance from the plane.
double share_off_plane(const tools::EdgeCloud& cloud, double distance_m) {
  const support::TexturedPlane plane;
  const auto off = std::count_if(cloud.begin(), cloud.end(), [&](const CloudPoint& point) {
    return std::abs(plane.normal.dot(point.p_world.cast<double>() - plane.point)) > distance_m;
  });
  return static_cast<double>(off) / static_cast<double>(cloud.size());
}

/// The mean difference, 0..1, of the points' greys and the plane's where they lie.
double grey_difference(const tools::EdgeCloud& cloud) {
  double sum = 0;
  for (const CloudPoint& point : cloud) {
    sum += std::abs(point.grey / 255.0 -
                    support::TexturedPlane::texture(point.p_world.cast<double>()));
  }
  return sum / static_cast<double>(cloud.size());
}

TEST(KeyframeCloud, HasThePointsOfEveryKeyframeWhereTheyAre) {
  KeyframeCloud collected;
  const vo::FrameObserver observe = collected.observer({});
  vo::TrackerOptions options = vo::preset_options(vo::TrackerPreset::best_measured);
  options.map.max_keyframes = 4;
  vo::RgbdOdometry odometry(small_camera(), options);
  std::size_t keyframes = 0;
  std::size_t points = 0;
  for (int i = 0; i < 60; ++i) {
    const vo::RgbdFrame frame = support::plane_frame(small_camera(), sideways_walk(i), i);
    const vo::TrackingResult result = odometry.track(frame);
    observe(frame, odometry.current(), odometry.tracker(), result, odometry.stage_times());
    if (result.is_keyframe) {
      ++keyframes;
      points += odometry.tracker().map().last()->points->levels.front().size();
    }
  }
  EXPECT_GT(keyframes, odometry.tracker().map().keyframes().size());
  const tools::EdgeCloud cloud = collected.finish();
  EXPECT_EQ(cloud.size(), points);
  EXPECT_EQ(share_off_plane(cloud, 0.01), 0);
  EXPECT_LT(grey_difference(cloud), 0.05);
  for (const CloudPoint& point : cloud) {
    EXPECT_GT(point.inverse_depth_sigma, 0);
  }
}

/// A metric map is lost by a jump of 3 m, and the camera comes back in a new one, whose scale is a
/// guess and whose points are therefore elsewhere: on the plane by chance, but not where its
/// texture is.
TEST(KeyframeCloud, LeavesOutAMapOfAnotherScaleThatWasJoined) {
  constexpr int kJump = 20;
  vo::MonoOptions options = vo::mono_options();
  options.bootstrap = vo::MonoBootstrap::rgbd;
  options.max_lost_frames = 3;
  vo::MonoOdometry odometry(small_camera(), options);
  KeyframeCloud collected;
  const vo::MonoObserver observe = collected.mono_observer();
  int joined = 0;
  for (int i = 0; i < 110; ++i) {
    const double back = i < kJump ? 0 : 3 - 0.04 * (i - kJump);
    const vo::RgbdFrame frame =
        support::plane_frame(small_camera(),
                             SE3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(back, 0, 0)) *
                                 sideways_walk(std::min(i, kJump)),
                             i);
    const vo::MonoResult result = odometry.track(frame);
    observe(frame, odometry, result);
    joined += result.joins_maps ? 1 : 0;
  }
  EXPECT_EQ(joined, 1);
  const tools::EdgeCloud cloud = collected.finish();
  EXPECT_GT(cloud.size(), 1000U);
  EXPECT_LT(share_off_plane(cloud, 0.1), 0.01);
  EXPECT_LT(grey_difference(cloud), 0.05);
}

TEST(CloudFormat, TellsItsFormatByTheEndingOfTheName) {
  EXPECT_EQ(tools::cloud_format_of("a/map.ply"), tools::CloudFormat::ply);
  EXPECT_EQ(tools::cloud_format_of("map.x.pcd"), tools::CloudFormat::pcd);
  EXPECT_EQ(support::error_text([] { tools::cloud_format_of("map.txt"); }),
            "map.txt: expected a name that ends in .ply or .pcd");
}

}  // namespace
