#include "synth/camera/sequence_camera.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/sensor/preset.h"
#include "tests/support/error_text.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using support::error_text;
using testing::HasSubstr;

/// A wall behind a box, and a lamp that the camera comes nearer to.
Scene lit_room() {
  Scene scene;
  add(scene, square_at(3, 4), diffuse({0.8F, 0.6F, 0.4F}));
  add(scene, square_at(2, 0.4F), diffuse({0.3F, 0.5F, 0.9F}));
  scene.lights.push_back(point_light({1, -1, 1}, {30, 30, 30}));
  return scene;
}

vo::SE3 drift(double time) {
  return {Eigen::Quaterniond::Identity(), Vector3d(0.4 * time, 0, 0.3 * time)};
}

CameraTruth drifting(int frames) {
  CameraTruth motion{.path = drift};
  for (int i = 0; i < frames; ++i) {
    motion.truth.push_back({i / 30.0, drift(i / 30.0)});
  }
  return motion;
}

/// What a sensor makes of the room, frame by frame.
class Recorder {
 public:
  explicit Recorder(const SensorOptions& options, int frames = 3,
                    const std::optional<InfraredBand>& infrared = std::nullopt)
      : motion_(drifting(frames)),
        renderers_(scene_, {}),
        sensor_(scene_, renderers_, camera_, motion_, options, infrared) {}

  vo::RgbdFrame take(std::size_t index) const { return sensor_.take(index); }
  const SequenceCamera& sensor() const { return sensor_; }
  const Renderer& renderer() const { return *renderers_.at(0); }
  const vo::PinholeCamera& camera() const { return camera_; }

 private:
  Scene scene_ = lit_room();
  vo::PinholeCamera camera_ = wide_camera();
  CameraTruth motion_;
  RenderersOverTime renderers_;
  SequenceCamera sensor_;
};

double max_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

TEST(SequenceCamera, ThatIsPerfectMeasuresWhatIsThere) {
  const Recorder recorder({.exposure = 0.3});
  const vo::RgbdFrame frame = recorder.take(2);
  const vo::RgbdFrame expected = measure(
      recorder.renderer().render(recorder.camera(), drift(2 / 30.0)), 2 / 30.0, {.exposure = 0.3});
  EXPECT_EQ(max_difference(frame.image, expected.image), 0);
  EXPECT_EQ(max_difference(frame.depth, expected.depth), 0);
  EXPECT_EQ(frame.timestamp, expected.timestamp);
}

TEST(SequenceCamera, TakesTheSameFrameInAnyOrder) {
  for (const auto& [preset, name] : enum_names(SensorPreset{})) {
    const Recorder forwards(preset_options(preset));
    const Recorder backwards(preset_options(preset));
    const vo::RgbdFrame last = backwards.take(2);
    forwards.take(0);
    EXPECT_EQ(max_difference(forwards.take(2).image, last.image), 0) << name;
    EXPECT_EQ(max_difference(forwards.take(2).depth, last.depth), 0) << name;
  }
}

TEST(SequenceCamera, HasOtherNoiseWithAnotherSeedAndInAnotherFrame) {
  SensorOptions options{.exposure = 0.3};
  options.noise.full_well = {500, 500, 500};
  options.depth.axial.constant = 0.01;
  const Recorder first(options);
  options.seed = 1;
  const Recorder second(options);
  EXPECT_GT(max_difference(first.take(0).image, second.take(0).image), 0);
  EXPECT_GT(max_difference(first.take(0).depth, second.take(0).depth), 0);
  options.depth.axial.seed = 7;
  const Recorder third(options);
  EXPECT_EQ(max_difference(second.take(0).image, third.take(0).image), 0);
  EXPECT_GT(max_difference(second.take(0).depth, third.take(0).depth), 0);
}

TEST(SequenceCamera, MeasuresDepthAtItsOwnStampAndPlace) {
  SensorOptions options{.exposure = 0.3};
  options.depth.delay = 0.02;
  const Recorder late(options);
  EXPECT_EQ(max_difference(late.take(1).depth,
                           late.renderer().render(late.camera(), drift(1 / 30.0 + 0.02)).depth),
            0);
  options.depth.delay = 0;
  options.depth.offset = {0, 0, -0.05};
  const Recorder behind(options);
  EXPECT_NEAR(behind.take(0).depth(24, 1), 3, 1e-5) << "registered to the colour camera";
}

TEST(SequenceCamera, MeasuresDepthAllAtOnceWithAGlobalShutter) {
  SensorOptions options{.exposure = 0.3, .shutter = {.readout_time = 0.03}};
  const Recorder rolling(options);
  options.depth.shutter = DepthShutter::global;
  const Recorder global(options);
  const vo::DepthImage at_once = global.renderer().render(global.camera(), drift(1 / 30.0)).depth;
  EXPECT_EQ(max_difference(global.take(1).depth, at_once), 0);
  EXPECT_GT(max_difference(rolling.take(1).depth, at_once), 0.003);
}

TEST(SequenceCamera, FollowsTheLightWithItsExposure) {
  SensorOptions options;
  options.auto_exposure = {.enabled = true, .time_constant = 0, .delay = 0};
  const Recorder recorder(options, 20);
  const double metered = meter(recorder.renderer(), recorder.camera(), drift(14 / 30.0)).exposure;
  EXPECT_NEAR(recorder.sensor().setting(15).exposure, metered, 1e-9);
  const FrameSetting& first = recorder.sensor().setting(0);
  const FrameSetting& last = recorder.sensor().setting(19);
  EXPECT_NE(first.exposure, last.exposure);
  EXPECT_NEAR(first.exposure / first.amplification, last.exposure / last.amplification, 1e-9);
}

TEST(SequenceCamera, StretchesItsExposureTimeBeforeItAmplifies) {
  SensorOptions options{.shutter = {.exposure_time = 0.01}};
  options.auto_exposure = {.enabled = true, .by = ExposureBy::time, .max_exposure_time = 0.0101};
  const Recorder recorder(options, 20);
  for (std::size_t i = 0; i < 20; ++i) {
    const FrameSetting& setting = recorder.sensor().setting(i);
    EXPECT_LE(setting.exposure_time, 0.0101);
    const double base = recorder.sensor().setting(0).exposure /
                        recorder.sensor().setting(0).amplification /
                        recorder.sensor().setting(0).exposure_time;
    EXPECT_NEAR(setting.exposure / setting.amplification / setting.exposure_time / base, 1, 1e-9);
  }
}

TEST(SequenceCamera, BalancesTheMeanToGrey) {
  SensorOptions options{.exposure = 0.3};
  options.white_balance = {.enabled = true, .time_constant = 0};
  const Recorder recorder(options);
  const Metering metered = meter(recorder.renderer(), recorder.camera(), drift(0));
  const Vector3d balanced = recorder.sensor().setting(0).balance.cwiseProduct(metered.mean);
  EXPECT_NEAR(balanced[0], balanced[1], 1e-9);
  EXPECT_NEAR(balanced[2], balanced[1], 1e-9);
}

TEST(Preset, IsValidAndBearsItsName) {
  for (const auto& [preset, name] : enum_names(SensorPreset{})) {
    const SensorOptions options = preset_options(preset);
    options.validate();
    EXPECT_EQ(options.preset, preset) << name;
  }
}

TEST(SensorOptions, DoNotMeterWhatIsGiven) {
  SensorOptions options{.exposure = 1};
  options.auto_exposure.enabled = true;
  EXPECT_THAT(error_text([&] { options.validate(); }), HasSubstr("expects exposure = 0"));
}

Material clear_glass() {
  Material glass = diffuse({1, 1, 1});
  glass.roughness = 0;
  glass.layers.transmission = 1;
  return glass;
}

TEST(SequenceCamera, LooksAtMaterialsWhereTheSensorTellsThemApart) {
  Scene scene = lit_room();
  EXPECT_FALSE(sees_materials(scene, {}));
  EXPECT_FALSE(sees_materials(scene, preset_options(SensorPreset::kinect_v1)));
  SensorOptions with_dark = {};
  with_dark.depth.materials.min_return = 0.01;
  EXPECT_TRUE(sees_materials(scene, with_dark)) << "any surface may be dark";
  add(scene, square_at(1, 0.2F), clear_glass());
  EXPECT_FALSE(sees_materials(scene, {}));
  EXPECT_TRUE(sees_materials(scene, preset_options(SensorPreset::kinect_v1)));
}

TEST(SequenceCamera, MeasuresThroughGlassWhatTheSensorSeesThere) {
  Scene scene = lit_room();
  add(scene, square_at(1, 0.1F), clear_glass());
  const vo::PinholeCamera camera = wide_camera();
  const CameraTruth motion{.truth = {{0, {}}}, .path = [](double) { return vo::SE3(); }};
  const RenderersOverTime renderers(scene, {});
  const auto middle_of = [&](ClearSurface measured, double delay) {
    SensorOptions options{.exposure = 0.3};
    options.depth.delay = delay;
    options.depth.materials.glass = measured;
    return SequenceCamera(scene, renderers, camera, motion, options).take(0).depth(24, 32);
  };
  for (const double delay : {0.0, 0.01}) {  // in one capture with colour, and in its own
    EXPECT_NEAR(middle_of(ClearSurface::surface, delay), 1, 1e-6);
    EXPECT_NEAR(middle_of(ClearSurface::beyond, delay), 2, 1e-6);
    EXPECT_EQ(middle_of(ClearSurface::lost, delay), 0);
  }
}

TEST(SequenceCamera, AnInfraredImageIsGreyWithOneNoise) {
  SensorOptions noisy = preset_options(SensorPreset::realsense_d435);
  const vo::ColorImage image = cv::Mat(Recorder(noisy, 3, InfraredBand{0.5, {}}).take(1).image);
  for (const cv::Vec3b& pixel : image) {
    EXPECT_TRUE(pixel[0] == pixel[1] && pixel[2] == pixel[1]);
  }
  noisy.noise = {};
  const vo::ColorImage clean = cv::Mat(Recorder(noisy, 3, InfraredBand{0.5, {}}).take(1).image);
  EXPECT_GT(cv::norm(image, clean, cv::NORM_L1), 0);
}

TEST(SequenceCamera, WhiteBalanceChangesNothingInInfrared) {
  SensorOptions plain = preset_options(SensorPreset::realsense_d435);
  plain.white_balance = {};
  SensorOptions balanced = plain;
  // Automatic gains are scaled until the least is 1: one of red below 1 raises that of green.
  balanced.white_balance = {.red = 0.5, .enabled = true};
  const auto difference = [&](const std::optional<InfraredBand>& band) {
    return max_difference(Recorder(balanced, 3, band).take(1).image,
                          Recorder(plain, 3, band).take(1).image);
  };
  EXPECT_EQ(difference(InfraredBand{0.5, {}}), 0);
  EXPECT_GT(difference(std::nullopt), 0);
}

TEST(SequenceCamera, AnInfraredCameraMetersTheMeanOfWhatItSees) {
  // A pattern of one dot in darkness, most of whose view would have the median 0.
  Projector dot{.power = 50, .pattern = cv::Mat_<float>(9, 9, 0.0F)};
  dot.pattern(4, 4) = 1;
  const InfraredBand band{0, {dot}};
  const Recorder recorder({}, 1, band);
  Capture capture = still(recorder.camera(), drift(0));
  capture.infrared = band;
  const RenderedFrame view = recorder.renderer().render(capture);
  EXPECT_NEAR(recorder.sensor().setting(0).exposure * cv::mean(view.radiance)[1], 0.18, 1e-6);
}

}  // namespace
}  // namespace synth
