#include "synth/sensor/sensor.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/camera/metering.h"
#include "synth/camera/renderers_over_time.h"
#include "synth/scene/srgb.h"
#include "tests/support/error_text.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using support::error_text;
using testing::HasSubstr;

TEST(Srgb, EncodingInvertsDecodingOfEveryCode) {
  for (int code = 0; code < 256; ++code) {
    const float encoded = static_cast<float>(code) / 255;
    EXPECT_NEAR(encode_srgb(decode_srgb(encoded)), encoded, 1e-6) << "code " << code;
    const auto byte = static_cast<std::uint8_t>(code);
    EXPECT_EQ(decode_srgb_8bit(byte), decode_srgb(encoded)) << "code " << code;
    EXPECT_EQ(encode_srgb_8bit(decode_srgb_8bit(byte)), byte);
  }
}

TEST(Srgb, HasTheValuesOfTheStandard) {
  EXPECT_EQ(encode_srgb(0), 0);
  EXPECT_NEAR(encode_srgb(1), 1, 1e-6);
  EXPECT_NEAR(encode_srgb(0.18F), 0.46135613, 1e-6);  // (1.055 * 0.18^(1 / 2.4) - 0.055)
  EXPECT_NEAR(encode_srgb(0.002F), 0.02584, 1e-7);    // the linear part, 12.92 * 0.002
  EXPECT_NEAR(decode_srgb(0.5F), 0.21404114, 1e-6);
}

RenderedFrame one_pixel(const cv::Vec3f& radiance, float depth) {
  return {.radiance = cv::Mat_<cv::Vec3f>(1, 1, radiance), .depth = vo::DepthImage(1, 1, depth)};
}

cv::Vec3b measured_color(const cv::Vec3f& radiance, double exposure) {
  const vo::RgbdFrame frame = measure(one_pixel(radiance, 1), 0, {.exposure = exposure});
  return frame.image.at<cv::Vec3b>(0, 0);
}

TEST(Measure, EncodesTheExposedRadianceAsBlueGreenRed) {
  const auto linear = [](int code) { return decode_srgb(static_cast<float>(code) / 255); };
  const cv::Vec3f radiance(linear(200), linear(30), linear(4));
  EXPECT_EQ(measured_color(radiance, 1), cv::Vec3b(4, 30, 200));
  EXPECT_EQ(measured_color(radiance / 8, 8), cv::Vec3b(4, 30, 200));
}

TEST(Measure, SaturatesAndShowsWhatIsNotANumberAsBlack) {
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(measured_color({7, -1, not_a_number}, 1), cv::Vec3b(0, 0, 255));
}

TEST(Measure, TakesDepthOnlyWithinItsLimits) {
  const SensorOptions options{.exposure = 1, .min_depth = 0.5, .max_depth = 4};
  const auto depth_of = [&](float depth) {
    return measure(one_pixel({}, depth), 0, options).depth(0, 0);
  };
  EXPECT_EQ(depth_of(0.4999F), 0);
  EXPECT_EQ(depth_of(0.5F), 0.5F);
  EXPECT_EQ(depth_of(4), 4);
  EXPECT_EQ(depth_of(4.001F), 0);
}

TEST(Measure, KeepsTheTimestamp) {
  EXPECT_EQ(measure(one_pixel({}, 1), 1.25, {.exposure = 1}).timestamp, 1.25);
}

TEST(Measure, NeedsAnExposure) {
  EXPECT_THAT(error_text([] { measure(one_pixel({}, 1), 0, {}); }),
              HasSubstr("expected an exposure above 0, got 0"));
}

/// A lamp at the camera before a white wall that fills the view.
Scene lit_wall() {
  Scene scene;
  add(scene, square_at(2, 9), diffuse({1, 1, 1}));
  scene.lights.push_back(point_light({0, 0, 0}, {50, 50, 50}));
  return scene;
}

double metered(const Scene& scene, const vo::Trajectory& trajectory) {
  return meter_exposure(scene, RenderersOverTime(scene, {}), wide_camera(), trajectory);
}

TEST(MeterExposure, BringsTheMedianToMiddleGrey) {
  Scene scene = lit_wall();
  scene.lights[0] = {.kind = LightKind::directional,
                     .direction = Eigen::Vector3d::UnitZ(),
                     .intensity = Eigen::Vector3f::Constant(20)};
  const auto renderer = make_renderer(scene, {});
  const float wall = renderer->render(wide_camera(), {}).radiance(24, 32)[0];
  EXPECT_NEAR(metered(scene, {{0, {}}, {1, {}}}), 0.18 / wall, 1e-6);
}

TEST(MeterExposure, IsTheSameEachTime) {
  const vo::Trajectory trajectory(30);
  EXPECT_EQ(metered(lit_wall(), trajectory), metered(lit_wall(), trajectory));
}

TEST(MeterExposure, LooksAtTheFirstAndTheLastPose) {
  const vo::SE3 away(Eigen::Quaterniond(0, 0, 1, 0), Eigen::Vector3d::Zero());  // sees nothing
  const double expected = metered(lit_wall(), {{0, {}}});
  for (const std::size_t seen : {0U, 19U}) {
    vo::Trajectory trajectory(20, {0, away});
    trajectory[seen].T_world_camera = {};
    EXPECT_EQ(metered(lit_wall(), trajectory), expected);
  }
}

/// The wall jumps aside after half a second; behind it is one of a quarter of its grey.
Scene wall_that_leaves() {
  Scene scene = lit_wall();
  scene.lights[0] = {.kind = LightKind::directional,
                     .direction = Eigen::Vector3d::UnitZ(),
                     .intensity = Eigen::Vector3f::Constant(20)};
  add(scene, square_at(3, 99), diffuse({0.25F, 0.25F, 0.25F}));
  scene.motion.nodes.resize(3);
  scene.motion.instance_nodes = {0, 1};
  scene.motion.light_nodes = {2};
  scene.motion.nodes[2].T_parent_node =  // glTF's lights shine along -z
      Eigen::Quaterniond::FromTwoVectors(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ());
  scene.motion.animations = {{.duration = 0.5,
                              .channels = {{.property = AnimatedProperty::translation,
                                            .curve = {.interpolation = Interpolation::step,
                                                      .width = 3,
                                                      .times = {0, 0.5F},
                                                      .values = {0, 0, 0, 500, 0, 0}}}}}};
  return scene;
}

TEST(MeterExposure, SeesWhatIsThereAtTheTimeOfEachPose) {
  const Scene scene = wall_that_leaves();
  const RenderersOverTime renderers(scene, {.ambient = 0});
  const auto exposure_at = [&](double time) {
    return meter_exposure(scene, renderers, wide_camera(),
                          {{3, {}}, {3 + time, {}}, {3 + time, {}}});
  };
  EXPECT_NEAR(exposure_at(1) / exposure_at(0.1), 4, 1e-5);
}

TEST(MeterExposure, IsOneWhereThereIsNothingToMeter) {
  const vo::SE3 away(Eigen::Quaterniond(0, 0, 1, 0), Eigen::Vector3d::Zero());
  EXPECT_EQ(metered(lit_wall(), {{0, away}}), 1) << "nothing in sight";
  Scene dark = lit_wall();
  dark.materials[0].base_color.setZero();
  EXPECT_EQ(metered(dark, {{0, {}}}), 1) << "all black";
  Scene unlit_wall = lit_wall();
  unlit_wall.materials[0].unlit = true;
  EXPECT_EQ(metered(unlit_wall, {{0, {}}}), 1) << "colours are final";
  Scene no_lights = lit_wall();
  no_lights.lights.clear();
  EXPECT_EQ(metered(no_lights, {{0, {}}}), 1) << "colours are final";
}

TEST(SensorOptions, TheDepthCameraIsNearInPlaceAndTime) {
  DepthSensorOptions depth;
  depth.offset = {1000, 0, 0};
  depth.delay = -60;
  EXPECT_NO_THROW(depth.validate());
  depth.delay = 1e308;
  EXPECT_THAT(error_text([&] { depth.validate(); }),
              HasSubstr("expected a delay from -60 to 60 s, got 1e+308"));
  depth.delay = 0;
  depth.offset = {0, 1e20, 0};
  EXPECT_THAT(error_text([&] { depth.validate(); }),
              HasSubstr("expected an offset of at most 1000 m, got 1e+20"));
}

TEST(SensorOptions, DepthLimitsMustBeInOrder) {
  EXPECT_NO_THROW(SensorOptions{}.validate());
  EXPECT_THAT(error_text([] { SensorOptions{.min_depth = 3, .max_depth = 2}.validate(); }),
              HasSubstr("expected 0 <= min_depth < max_depth, got 3, 2"));
  EXPECT_THAT(error_text([] { SensorOptions{.exposure = -1}.validate(); }),
              HasSubstr("expected exposure at or above 0, got -1"));
}

TEST(SensorOptions, AnExposureEnds) {
  SensorOptions options;
  options.auto_exposure.max_exposure_time = 60;
  EXPECT_NO_THROW(options.validate());
  for (const double time : {0.0, 61.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    options.auto_exposure.max_exposure_time = time;
    EXPECT_THAT(error_text([&] { options.validate(); }),
                HasSubstr("max_exposure_time: expected above 0 and at most 60 s, got "));
  }
}

}  // namespace
}  // namespace synth
