#include "vo/tracking/readout_estimate.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/pose_near.h"
#include "tests/support/textured_plane.h"
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

/// Rows are exposed from `readout` / 2 before the frame's time to as much after it.
vo::RgbdFrame rolled_frame(const vo::PinholeCamera& camera, double time, double readout) {
  const auto T_world_row = [&](int v) {
    return shaken(time + readout * ((v + 0.5) / camera.height - 0.5));
  };
  return support::TexturedPlane().render_rows(camera, T_world_row, time);
}

struct Drive {
  double readout_s = 0;
  double worst_m = 0;  ///< distance from the pose of the middle row, of any frame
};

/// Tracks a shaken camera with `track`, a function that returns the result of a frame.
template <typename Track>
Drive drive(const vo::PinholeCamera& camera, double readout, double start, Track track) {
  Drive found;
  for (int i = 0; i < kFrames; ++i) {
    const double time = start + i / 30.0;
    const vo::TrackingResult result = track(rolled_frame(camera, time, readout));
    EXPECT_NE(result.status, vo::TrackingStatus::lost) << "frame " << i;
    const SE3 T_world_middle = shaken(time);
    const double distance =
        (T_world_middle.translation() - result.T_world_camera.translation()).norm();
    found.worst_m = std::max(found.worst_m, distance);
    found.readout_s = result.readout_s;
  }
  return found;
}

vo::PinholeCamera shaken_camera() {
  return vo::PinholeCamera::from_horizontal_fov(240, 180, 60);
}

Drive drive_rgbd(double readout, double start) {
  const vo::PinholeCamera camera = shaken_camera();
  vo::RgbdOdometry odometry(camera, vo::preset_options(vo::TrackerPreset::best_measured),
                            shaken(start));
  return drive(camera, readout, start,
               [&](const vo::RgbdFrame& frame) { return odometry.track(frame); });
}

/// Drives monocular odometry that is given the depth of the first frame.
Drive drive_mono(double readout, vo::ShutterModel shutter) {
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
    const Drive found = drive_rgbd(0.020, start);
    EXPECT_NEAR(found.readout_s, 0.020, 0.004) << "from " << start << " s";
    EXPECT_LT(found.worst_m, 10e-3) << "from " << start << " s";
  }
}

TEST(ReadoutEstimate, FindsAGlobalShutter) {
  const Drive found = drive_rgbd(0, 0.4);
  EXPECT_LT(found.readout_s, 0.001);
  EXPECT_LT(found.worst_m, 1e-3) << "a tenth of a pixel";
}

TEST(ReadoutEstimate, FindsARollingShutterOnDepthsOfAMap) {
  const Drive found = drive_mono(0.020, vo::ShutterModel::estimated);
  const Drive ignoring = drive_mono(0.020, vo::ShutterModel::given);
  EXPECT_NEAR(found.readout_s, 0.020, 0.006);
  EXPECT_LT(found.worst_m, 0.5 * ignoring.worst_m);
}

TEST(ReadoutEstimate, FindsAGlobalShutterOnDepthsOfAMap) {
  EXPECT_EQ(drive_mono(0, vo::ShutterModel::estimated).readout_s, 0);
}

TEST(ReadoutEstimate, StartsWhereItIsTold) {
  EXPECT_NEAR(vo::ReadoutEstimate(0.012).seconds(), 0.012, 1e-12);
  EXPECT_NEAR(vo::ReadoutEstimate(1).seconds(), 0.033, 1e-12) << "at most a frame's time";
}

}  // namespace
