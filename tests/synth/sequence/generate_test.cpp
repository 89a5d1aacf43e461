#include "synth/sequence/generate.h"

#include <filesystem>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "synth/camera/make_renderer.h"
#include "synth/path/camera_path.h"
#include "synth/sequence/frame_share.h"
#include "synth/sequence/share_renderer.h"
#include "tests/support/error_text.h"
#include "tests/support/folder_contents.h"
#include "tests/support/quads.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/trajectory_file.h"

namespace synth {
namespace {

namespace fs = std::filesystem;
using support::contents;
using support::error_text;
using testing::ElementsAre;
using testing::HasSubstr;

const vo::RgbdCamera kCamera{.pinhole = wide_camera()};

/// Two squares that lie in one plane, which of them is seen being the renderer's choice, and a
/// wall.
Scene small_room() {
  Scene scene;
  add(scene, square_at(0, 1), diffuse({1, 0.2F, 0.2F}));
  add(scene, square_at(0, 1), diffuse({0.2F, 1, 0.2F}));
  add(scene, square_at(-2, 3), diffuse({0.7F, 0.7F, 0.7F}));
  scene.lights.push_back(point_light({1, 2, 3}, {40, 40, 40}));
  return scene;
}

vo::Trajectory short_orbit() {
  return sample(orbit({.radius = 2.5, .height = 0.5}), 4, 1.25);
}

void generate(const Scene& scene, const SequenceRecipe& recipe, const fs::path& folder,
              const vo::Progress& progress = {}) {
  const vo::StagedContent content = sequence_content(recipe, {"marker", ""});
  vo::StagedFolder staged(folder, content, vo::ExistingOutput::keep, {});
  const ShareJob job{content, frames_of({}, recipe.truth.size()), [&]() -> PartMaker {
                       const auto generator = std::make_shared<const FrameGenerator>(scene, recipe);
                       return [generator](std::size_t frame) { return generator->make(frame); };
                     }};
  ShareRenderer renderer(job, staged, {progress, {}});
  renderer.render(job.parts);
  ASSERT_THAT(staged.finish(), testing::IsEmpty());
}

void generate(const fs::path& folder, const vo::Progress& progress = {}) {
  generate(small_room(),
           {.truth = short_orbit(), .camera = kCamera, .float_depth = vo::FloatDepth::npy}, folder,
           progress);
}

/// Expects the same bytes on one thread and on two, and others than those of a folder.
void expect_same_bytes_unlike(const fs::path& other, const SequenceRecipe& recipe) {
  const support::TempFolder one;
  const support::TempFolder two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    generate(small_room(), recipe, one.path());
  }
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    generate(small_room(), recipe, two.path());
  }
  EXPECT_EQ(contents(one.path()), contents(two.path()));
  EXPECT_NE(contents(one.path()), contents(other));
}

TEST(GenerateSequence, WritesTheSameBytesOnOneThreadAndOnTwo) {
  const support::TempFolder one;
  const support::TempFolder two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    generate(one.path());
  }
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    generate(two.path());
  }
  EXPECT_EQ(contents(one.path()).size(), 3 * 6 + 5 + 2U);
  EXPECT_EQ(contents(one.path()), contents(two.path()));
}

TEST(GenerateSequence, FollowsLightToTheSameDepthOnAnyNumberOfThreads) {
  SequenceRecipe recipe{
      .truth = short_orbit(), .camera = kCamera, .float_depth = vo::FloatDepth::npy};
  const support::TempFolder straight;
  generate(small_room(), recipe, straight.path());
  recipe.sensor.depth.multipath = {.frequency = 200e6, .samples = 2, .lamp = LampField::all};
  expect_same_bytes_unlike(straight.path(), recipe);
}

TEST(GenerateSequence, DenoisesByTheFramesAroundOnAnyNumberOfThreads) {
  SequenceRecipe recipe{.truth = short_orbit(), .camera = kCamera};
  recipe.render = {.mode = RenderMode::path, .denoise = true};
  const support::TempFolder alone;
  generate(small_room(), recipe, alone.path());
  recipe.render.denoise_frames = 1;
  expect_same_bytes_unlike(alone.path(), recipe);
}

TEST(GenerateSequence, WritesWhatTheSensorMeasuresAtThePosesOfTheTruth) {
  const support::TempFolder folder;
  generate(folder.path());
  const Scene scene = small_room();
  const vo::Trajectory truth = short_orbit();
  const auto renderer = make_renderer(scene, {});
  const SensorOptions sensor{
      .exposure = meter_exposure(scene, RenderersOverTime(scene, {}), kCamera.pinhole, truth)};
  const vo::RgbdFrame expected =
      measure(renderer->render(kCamera.pinhole, truth[3].T_world_camera), 0, sensor);
  const cv::Mat color = vo::read_png(folder.path() / "rgb/000003.png");
  EXPECT_EQ(cv::norm(color, expected.image, cv::NORM_INF), 0);
  const vo::DepthImage depth = vo::read_npy(folder.path() / "depth_float/000003.npy");
  EXPECT_EQ(cv::norm(depth, expected.depth, cv::NORM_INF), 0);
  EXPECT_EQ(vo::read_file(folder.path() / "groundtruth.txt"), vo::format_trajectory(truth));
}

TEST(GenerateSequence, TellsOfEveryFrame) {
  const support::TempFolder folder;
  std::vector<std::size_t> done;
  generate(folder.path(), [&](std::size_t count, std::size_t total) {
    EXPECT_EQ(total, 6U);
    done.push_back(count);
  });
  EXPECT_THAT(done, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(GenerateSequence, StopsWhenToldTo) {
  const support::TempFolder folder;
  const auto stop = [](std::size_t, std::size_t) { vo::fail("stopped"); };
  EXPECT_EQ(error_text([&] { generate(folder.path(), stop); }), "stopped");
}

TEST(GenerateSequence, NeedsAPose) {
  const SequenceRecipe nothing{.camera = kCamera};
  EXPECT_THAT(error_text([&] { FrameGenerator(small_room(), nothing); }),
              HasSubstr("no poses to render"));
}

/// A wall 2 m away at first, and 4 m away after a second.
Scene receding_wall() {
  Scene scene;
  add(scene, square_at(2, 9), diffuse({0.7F, 0.7F, 0.7F}));
  scene.motion.nodes.resize(1);
  scene.motion.instance_nodes = {0};
  scene.motion.animations = {
      {.duration = 1,
       .channels = {{.property = AnimatedProperty::translation,
                     .curve = {.width = 3, .times = {0, 1}, .values = {0, 0, 0, 0, 0, 2}}}}}};
  return scene;
}

TEST(GenerateSequence, RefusesACameraBeyondWhereRaysCanBeComputed) {
  SequenceRecipe far{.camera = kCamera};
  far.truth = {{0, {}}, {0.5, vo::SE3(Eigen::Quaterniond::Identity(), {0, 1e19, 0})}};
  EXPECT_THAT(error_text([&] { FrameGenerator(small_room(), far); }),
              HasSubstr("the camera is 1e+19 m from the origin at 0.5 s, expected within 1e+07 m"));
}

TEST(GenerateSequence, MovesTheSceneFromTheFirstStampOn) {
  const support::TempFolder folder;
  const vo::Trajectory truth = {{1e9, {}}, {1e9 + 0.5, {}}, {1e9 + 2, {}}};
  generate(receding_wall(), {.truth = truth, .camera = kCamera, .float_depth = vo::FloatDepth::npy},
           folder.path());
  const std::vector<float> expected = {2, 3, 4};  // m
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const fs::path file = folder.path() / ("depth_float/00000" + std::to_string(i) + ".npy");
    const cv::Mat_<float> depth = vo::read_npy(file);
    EXPECT_NEAR(depth(24, 32), expected[i], 1e-6) << "frame " << i;
  }
}

/// The wall recedes by 2 m/s, the middle row is read at the stamp.
TEST(GenerateSequence, MeasuresMovingThingsWhenEachRowIsRead) {
  const support::TempFolder folder;
  SequenceRecipe recipe{
      .truth = {{5, {}}, {5.5, {}}}, .camera = kCamera, .float_depth = vo::FloatDepth::npy};
  recipe.sensor.shutter.readout_time = 0.1;
  recipe.sensor.depth.delay = 0.05;
  generate(receding_wall(), recipe, folder.path());
  const cv::Mat_<float> depth = vo::read_npy(folder.path() / "depth_float/000001.npy");
  for (int v = 0; v < depth.rows; ++v) {
    const double time = 0.5 + 0.05 + recipe.sensor.shutter.row_time(v, depth.rows);
    EXPECT_NEAR(depth(v, 32), 2 + 2 * time, 1e-5) << "row " << v;
  }
}

TEST(GenerateSequence, AFrameOfAMovingSceneDependsOnItsIndexAlone) {
  const support::TempFolder all;
  const SequenceRecipe recipe{.truth = {{5, {}}, {5.25, {}}, {5.75, {}}}, .camera = kCamera};
  const Scene scene = receding_wall();
  generate(scene, recipe, all.path());
  const FrameGenerator alone(scene, recipe);
  for (const vo::NamedBytes& file : alone.make(2).files) {
    EXPECT_EQ(vo::read_file(all.path() / file.name), file.bytes) << file.name;
  }
}

}  // namespace
}  // namespace synth
