#include "vo/tracking/vignette_estimate.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/odometry/rgbd_odometry.h"

namespace {

using vo::SE3;

constexpr int kDriveFrames = 30;

SE3 swaying(double time) {
  vo::Vector6d xi;
  xi << 0.10 * std::sin(2 * time), 0.08 * std::sin(3 * time), 0.05 * std::sin(1.5 * time),
      0.06 * std::sin(2.5 * time), 0.08 * std::sin(2 * time), 0.03 * std::sin(4 * time);
  return SE3::exp(xi);
}

struct VignettedDrive {
  vo::Vignette vignette;
  double worst_m = 0;  ///< distance from the true position, of any of the last ten frames
};

/// Through a lens whose images are those of the scene over 1 + c_0 rho^2 + c_1 rho^4.
VignettedDrive drive(const vo::Vignette& lens, vo::VignetteModel model) {
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(240, 180, 60);
  vo::TrackerOptions options = vo::preset_options(vo::TrackerPreset::best_measured);
  options.vignette = model;
  vo::RgbdOdometry odometry(camera, options);
  VignettedDrive found;
  for (int i = 0; i < kDriveFrames; ++i) {
    const double time = i / 30.0;
    vo::RgbdFrame frame = support::TexturedPlane().render(camera, swaying(time), time);
    vo::GrayImage seen = vo::to_gray(frame.image);
    take_out({}, camera, lens, seen);
    seen.convertTo(frame.image, CV_8U, 255);
    const vo::TrackingResult result = odometry.track(frame);
    EXPECT_NE(result.status, vo::TrackingStatus::lost) << "frame " << i;
    const double distance =
        (swaying(time).translation() - result.T_world_camera.translation()).norm();
    found.worst_m = i < kDriveFrames - 10 ? 0 : std::max(found.worst_m, distance);
    found.vignette = result.vignette;
  }
  return found;
}

TEST(VignetteEstimate, FindsTheLightThatALensTakes) {
  const vo::Vignette lens{{0.5, 0.2}};
  const VignettedDrive estimated = drive(lens, vo::VignetteModel::estimated);
  for (const double rho2 : {0.25, 0.5, 0.75}) {
    const Eigen::Vector2d terms(rho2, rho2 * rho2);
    EXPECT_NEAR(estimated.vignette.gain(terms), lens.gain(terms), 0.04) << "rho^2 " << rho2;
  }
  EXPECT_LT(estimated.worst_m, 0.7 * drive(lens, vo::VignetteModel::ignore).worst_m);
}

TEST(VignetteEstimate, TakesNothingOutOfImagesWithoutOne) {
  const VignettedDrive found = drive({}, vo::VignetteModel::estimated);
  EXPECT_NEAR(found.vignette.gain(Eigen::Vector2d::Ones()), 1, 0.02) << "at the corners";
}

}  // namespace
