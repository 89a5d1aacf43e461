#include "synth/rendering/capture.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/error_text.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using support::error_text;
using testing::HasSubstr;

/// A white square before a grey wall that leans.
Scene square_before_wall() {
  Scene scene;
  add(scene, square_at(2, 0.7F), unlit({1, 1, 1}));
  add(scene, quad({-16, -16, 2}, {32, 0, 4}, {0, 32, 0}), unlit({0.2F, 0.2F, 0.2F}));
  return scene;
}

/// 1.5 m/s to the right and a turn of 0.5 rad/s about the optical axis.
vo::SE3 sweep(double time) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * time, Vector3d::UnitZ())),
          Vector3d(1.5 * time, 0.1 * time, 0)};
}

Capture sweeping(const Shutter& shutter) {
  return {.camera = wide_camera(), .motion = sweep, .shutter = shutter};
}

RenderedFrame taken(const Capture& capture, int samples = 4) {
  const Scene scene = square_before_wall();
  return make_renderer(scene, {.samples = samples})->render(capture);
}

RenderedFrame seen_at_rest(double time) {
  return taken(still(wide_camera(), sweep(time)));
}

double max_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

TEST(Shutter, ExposesTheMiddleRowAtTheStampAndRowsEvenlyAroundIt) {
  const Shutter shutter{.readout_time = 0.02};
  EXPECT_DOUBLE_EQ(shutter.row_time(2, 5), 0);
  EXPECT_NEAR(shutter.row_time(4, 5), 0.008, 1e-15);
  EXPECT_NEAR(shutter.row_time(0, 5), -0.008, 1e-15);
}

TEST(Shutter, TimesAreNeitherNegativeNorLongerThanAMinute) {
  EXPECT_NO_THROW((Shutter{.exposure_time = 60, .readout_time = 60}.validate()));
  for (const double time : {60.1, 1e308}) {
    EXPECT_THROW(Shutter{.exposure_time = time}.validate(), vo::Error);
    EXPECT_THROW(Shutter{.readout_time = time}.validate(), vo::Error);
  }
  EXPECT_THAT(error_text([] { Shutter{.exposure_time = -1}.validate(); }),
              HasSubstr("expected exposure_time from 0 to 60 s, got -1"));
  EXPECT_THAT(error_text([] { Shutter{.readout_time = -1}.validate(); }),
              HasSubstr("readout_time"));
}

TEST(Capture, OfAnInstantIsWhatACameraAtRestSees) {
  const RenderedFrame moving = taken(sweeping({}));
  EXPECT_EQ(max_difference(moving.radiance, seen_at_rest(0).radiance), 0);
  EXPECT_EQ(max_difference(moving.depth, seen_at_rest(0).depth), 0);
}

TEST(Capture, OfARollingShutterHasEachRowAsACameraAtRestSeesItAtThatTime) {
  const Shutter shutter{.readout_time = 0.2};
  const RenderedFrame rolling = taken(sweeping(shutter));
  for (int v = 0; v < wide_camera().height; ++v) {
    const RenderedFrame row = seen_at_rest(shutter.row_time(v, wide_camera().height));
    ASSERT_EQ(max_difference(rolling.radiance.row(v), row.radiance.row(v)), 0) << "row " << v;
    ASSERT_EQ(max_difference(rolling.depth.row(v), row.depth.row(v)), 0) << "row " << v;
  }
}

/// The mean of sharp pictures at instants spread evenly over the exposure.
cv::Mat_<cv::Vec3f> mean_of_sharp(double exposure_time, int instants) {
  const Scene scene = square_before_wall();
  const auto renderer = make_renderer(scene, {.samples = 64});
  cv::Mat_<cv::Vec3f> mean(wide_camera().height, wide_camera().width, cv::Vec3f(0, 0, 0));
  for (int i = 0; i < instants; ++i) {
    const double time = exposure_time * ((i + 0.5) / instants - 0.5);
    mean += renderer->render(wide_camera(), sweep(time)).radiance / instants;
  }
  return mean;
}

TEST(Capture, OfAnExposureIsTheMeanOfSharpPictures) {
  constexpr double kExposure = 0.1;  // s; the square moves by 2.4 px
  const cv::Mat_<cv::Vec3f> expected = mean_of_sharp(kExposure, 32);
  const cv::Mat_<cv::Vec3f> blurred = taken(sweeping({.exposure_time = kExposure}), 64).radiance;
  const cv::Mat_<cv::Vec3f> sharp = taken(sweeping({}), 64).radiance;
  EXPECT_LT(max_difference(blurred, expected), 0.08);  // 64 samples of a step of 0.8
  const double rms =
      cv::norm(blurred, expected) / std::sqrt(3.0 * static_cast<double>(expected.total()));
  EXPECT_LT(rms, 0.004);
  EXPECT_GT(max_difference(sharp, expected), 0.2);
  EXPECT_NEAR(cv::mean(blurred)[0], cv::mean(expected)[0], 1e-4);
}

TEST(Capture, OfAnExposureHasTheDepthOfItsMiddle) {
  EXPECT_EQ(max_difference(taken(sweeping({.exposure_time = 0.1})).depth, seen_at_rest(0).depth),
            0);
}

TEST(Capture, HasTheInstantsOfItsSeed) {
  Capture capture = sweeping({.exposure_time = 0.1});
  const cv::Mat first = taken(capture, 4).radiance;
  EXPECT_EQ(max_difference(first, taken(capture, 4).radiance), 0);
  capture.seed = 1;
  EXPECT_GT(max_difference(first, taken(capture, 4).radiance), 0.1);
}

TEST(Capture, HasTheChannelsThatAreAskedFor) {
  Capture capture = still(wide_camera(), {});
  capture.channels = {.color = false, .depth = false, .normal = true};
  const RenderedFrame frame = taken(capture, 1);
  EXPECT_TRUE(frame.radiance.empty());
  EXPECT_TRUE(frame.depth.empty());
  const Vector3d leaning = Vector3d(4, 0, -32).normalized();  // of the wall, towards the camera
  const cv::Vec3f corner = frame.normal(0, 0);
  EXPECT_NEAR(corner[0], leaning.x(), 1e-6);
  EXPECT_NEAR(corner[2], leaning.z(), 1e-6);
  EXPECT_NEAR(frame.normal(24, 32)[2], -1, 1e-6);
}

}  // namespace
}  // namespace synth
