#include "vo/tracking/readout_estimate.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/pose_near.h"
#include "tests/support/textured_plane.h"
#include "vo/core/fields.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/odometry/rgbd_odometry.h"

namespace {

using vo::SE3;

constexpr int kFrames = 30;

/// A camera shaken by up to 50 deg/s and 0.3 m/s, from rest at 0 s.
SE3 shaken(double time) {
  const auto swing = [&](double frequency) { return 1 - std::cos(frequency * time); };
  vo::Vector6d xi;
  xi << 0.06 * swing(3), 0.05 * swing(4), 0.05 * swing(2.5), 0.08 * swing(4), 0.15 * swing(3),
      0.06 * swing(5);
  return SE3::exp(xi);
}

/// Lines are exposed from half the read-out time before the frame's time to as much after it.
vo::RgbdFrame rolled_frame(const vo::PinholeCamera& camera, double time,
                           const vo::Readout& readout) {
  const int lines = readout.axis == vo::ReadoutAxis::rows ? camera.height : camera.width;
  const auto T_world_line = [&](int line) {
    return shaken(time + readout.seconds * ((line + 0.5) / lines - 0.5));
  };
  return support::TexturedPlane().render_lines(camera, readout.axis, T_world_line, time);
}

struct Drive {
  vo::Readout readout;
  double worst_m = 0;  ///< distance from the pose of the middle line, of any frame
};

/// Tracks a shaken camera with `track`, a function that returns the result of a frame.
template <typename Track>
Drive drive(const vo::PinholeCamera& camera, const vo::Readout& readout, double start,
            Track track) {
  Drive found;
  for (int i = 0; i < kFrames; ++i) {
    const double time = start + i / 30.0;
    const vo::TrackingResult result = track(rolled_frame(camera, time, readout));
    EXPECT_NE(result.status, vo::TrackingStatus::lost) << "frame " << i;
    const SE3 T_world_middle = shaken(time);
    const double distance =
        (T_world_middle.translation() - result.T_world_camera.translation()).norm();
    found.worst_m = std::max(found.worst_m, distance);
    found.readout = result.readout;
  }
  return found;
}

vo::PinholeCamera shaken_camera() {
  return vo::PinholeCamera::from_horizontal_fov(240, 180, 60);
}

Drive drive_rgbd(const vo::Readout& readout, double start) {
  const vo::PinholeCamera camera = shaken_camera();
  vo::RgbdOdometry odometry(camera, vo::preset_options(vo::TrackerPreset::best_measured),
                            shaken(start));
  return drive(camera, readout, start,
               [&](const vo::RgbdFrame& frame) { return odometry.track(frame); });
}

/// Drives monocular odometry that is given the depth of the first frame.
Drive drive_mono(const vo::Readout& readout, vo::ShutterModel shutter) {
  const vo::PinholeCamera camera = shaken_camera();
  vo::MonoOptions options = vo::mono_options();
  options.bootstrap = vo::MonoBootstrap::rgbd;
  options.tracker.shutter = shutter;
  constexpr double kStart = 0.4;  // s
  vo::MonoOdometry odometry(camera, options, shaken(kStart));
  return drive(camera, readout, kStart,
               [&](const vo::RgbdFrame& frame) { return odometry.track(frame).tracking; });
}

/// Velocities are means over 33 ms, which shakes change by a fifth. A pixel is 10 mm wide on the
/// plane; with the shutter ignored, poses are off by 30 mm.
TEST(ReadoutEstimate, FindsARollingShutterFromRestAndInMotion) {
  for (const double start : {0.0, 0.4}) {
    const Drive found = drive_rgbd({.seconds = 0.020}, start);
    EXPECT_NEAR(found.readout.seconds, 0.020, 0.004) << "from " << start << " s";
    EXPECT_LT(found.worst_m, 10e-3) << "from " << start << " s";
  }
}

/// The camera hangs upside down, or stands on either side.
TEST(ReadoutEstimate, FindsWhichLinesARollingShutterReadsAndWhichComesFirst) {
  for (const vo::ReadoutAxis axis : {vo::ReadoutAxis::rows, vo::ReadoutAxis::columns}) {
    for (const double seconds : {0.020, -0.020}) {
      const Drive found = drive_rgbd({seconds, axis}, 0.4);
      EXPECT_EQ(found.readout.axis, axis) << seconds << " s";
      EXPECT_NEAR(found.readout.seconds, seconds, 0.004) << vo::to_string(axis);
      EXPECT_LT(found.worst_m, 10e-3) << vo::to_string(axis) << " in " << seconds << " s";
    }
  }
}

TEST(ReadoutEstimate, FindsAGlobalShutter) {
  const Drive found = drive_rgbd({}, 0.4);
  EXPECT_LT(std::abs(found.readout.seconds), 0.001);
  EXPECT_LT(found.worst_m, 1e-3) << "a tenth of a pixel";
}

TEST(ReadoutEstimate, FindsARollingShutterOnDepthsOfAMap) {
  const Drive found = drive_mono({.seconds = 0.020}, vo::ShutterModel::estimated);
  const Drive ignoring = drive_mono({.seconds = 0.020}, vo::ShutterModel::given);
  EXPECT_NEAR(found.readout.seconds, 0.020, 0.006);
  EXPECT_LT(found.worst_m, 0.5 * ignoring.worst_m);
}

TEST(ReadoutEstimate, FindsAGlobalShutterOnDepthsOfAMap) {
  EXPECT_EQ(drive_mono({}, vo::ShutterModel::estimated).readout.seconds, 0);
}

TEST(ReadoutEstimate, StartsWhereItIsTold) {
  const vo::Readout given{-0.012, vo::ReadoutAxis::columns};
  EXPECT_NEAR(vo::ReadoutEstimate(given).readout().seconds, given.seconds, 1e-12);
  EXPECT_EQ(vo::ReadoutEstimate(given).readout().axis, given.axis);
  EXPECT_NEAR(vo::ReadoutEstimate({.seconds = 1}).readout().seconds, 0.033, 1e-12)
      << "at most a frame's time";
}

}  // namespace
