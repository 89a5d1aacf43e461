#include "synth/rig/camera_jobs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/camera/renderers_over_time.h"
#include "synth/camera/sequence_camera.h"
#include "synth/path/camera_path.h"
#include "synth/sensor/preset.h"
#include "tests/support/error_text.h"
#include "tests/support/quads.h"
#include "tests/support/temp_folder.h"
#include "vo/rigs/rig_file.h"

namespace synth {
namespace {

using support::error_text;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kImage = "width=64\nheight=48\nfx=50.0\nfy=50.0\ncx=31.5\ncy=23.5\n";

RigJob job_of(const std::string& cameras) {
  const support::TempFolder folder;
  RigJob job{vo::read_rig(folder.write("rig.toml", cameras)), {}};
  job.body.recipe.path = orbit({.radius = 2, .period = 8});
  job.body.recipe.truth = sample(job.body.recipe.path, {1.0, 1.5, 2.0});
  return job;
}

std::string camera(const std::string& name, const std::string& rest = "") {
  return "[[camera]]\nname=\"" + name + "\"\n" + kImage + rest + "\n";
}

TEST(CameraJobs, EachCameraHasThePosesOfItsMountOnTheBodyAtItsOwnTime) {
  const RigJob job = job_of(
      camera("a") +
      camera("b", "position=[0.1,0.2,0.3]\norientation=[0.0,0.6,0.0,0.8]\ntime_offset=0.004"));
  const std::vector<RenderJob> jobs = camera_jobs(job);
  ASSERT_EQ(jobs.size(), 2U);
  const vo::SE3 T_body_b({0.8, 0, 0.6, 0}, {0.1, 0.2, 0.3});
  for (std::size_t i = 0; i < 3; ++i) {
    const vo::StampedPose& body = job.body.recipe.truth[i];
    const vo::StampedPose& a = jobs[0].recipe.truth[i];
    const vo::StampedPose& b = jobs[1].recipe.truth[i];
    EXPECT_EQ(a.timestamp, body.timestamp);
    EXPECT_EQ((a.T_world_camera.inverse() * body.T_world_camera).log().norm(), 0);
    EXPECT_EQ(b.timestamp, body.timestamp + 0.004);
    const vo::SE3 expected = job.body.recipe.path(body.timestamp + 0.004) * T_body_b;
    EXPECT_LT((b.T_world_camera.inverse() * expected).log().norm(), 1e-12);
  }
  EXPECT_EQ(jobs[1].recipe.scene_delay, 0.004);
}

TEST(CameraJobs, ASensorStartsFromItsPresetOrElseFromTheRigs) {
  RigJob job = job_of(camera("a") + camera("b", "sensor.preset=\"redwood\"\nsensor.min_depth=0.7") +
                      camera("c", "sensor.exposure=2.0"));
  job.body.recipe.sensor.max_depth = 7;
  const std::vector<RenderJob> jobs = camera_jobs(job);
  EXPECT_EQ(jobs[0].recipe.sensor.max_depth, 7);
  EXPECT_EQ(jobs[1].recipe.sensor.preset, SensorPreset::redwood);
  EXPECT_EQ(jobs[1].recipe.sensor.min_depth, 0.7);
  EXPECT_NE(jobs[1].recipe.sensor.max_depth, 7);
  EXPECT_EQ(jobs[2].recipe.sensor.max_depth, 7);
  EXPECT_EQ(jobs[2].recipe.sensor.exposure, 2);
  EXPECT_THAT(error_text([] { camera_jobs(job_of(camera("a", "sensor.min_depth=-1.0"))); }),
              HasSubstr("camera 'a': sensor: "));
  EXPECT_THAT(error_text([] { camera_jobs(job_of(camera("a", "sensor.minimum=1.0"))); }),
              HasSubstr("minimum"));
}

TEST(CameraJobs, NoTwoCamerasHaveOneSeedUnlessTheySaySo) {
  RigJob job =
      job_of(camera("a") + camera("b", "sensor.preset=\"redwood\"") + camera("c", "sensor.seed=5"));
  job.body.recipe.sensor.seed = 5;
  const std::vector<RenderJob> jobs = camera_jobs(job);
  EXPECT_EQ(jobs[0].recipe.sensor.seed, 5U);
  EXPECT_EQ(jobs[1].recipe.sensor.seed, 6U);
  EXPECT_EQ(jobs[2].recipe.sensor.seed, 5U);
}

TEST(CameraJobs, DisparityGoesToTheCameraThatNamesAPartner) {
  RigJob job = job_of(camera("l", "stereo=\"r\"") + camera("r", "position=[0.25,0.0,0.0]"));
  job.body.recipe.channels.channels = {TruthChannel::depth, TruthChannel::disparity};
  const std::vector<RenderJob> jobs = camera_jobs(job);
  EXPECT_EQ(jobs[0].recipe.channels.stereo_baseline, 0.25);
  EXPECT_THAT(jobs[0].recipe.channels.channels,
              ElementsAre(TruthChannel::depth, TruthChannel::disparity));
  EXPECT_THAT(jobs[1].recipe.channels.channels, ElementsAre(TruthChannel::depth));
  job.rig.cameras[0].stereo.clear();
  EXPECT_THAT(error_text([&] { camera_jobs(job); }), HasSubstr("names its partner"));
}

TEST(CameraJobs, TheTexturesOfARigAreThoseThatAnyOfItsSensorsNeeds) {
  const auto needed = [](const std::string& sensor, SensorPreset of_all = SensorPreset::perfect) {
    RigJob job{job_of(camera("a", sensor) + camera("b", "sensor.preset=\"perfect\"")).rig, {}};
    job.body.recipe.render.mode = RenderMode::depth;
    job.body.recipe.sensor = preset_options(of_all);
    return needed_textures(job);
  };
  EXPECT_EQ(needed(""), NeededTextures::alpha);
  EXPECT_EQ(needed("sensor.depth.multipath.frequency=200e6"), NeededTextures::surfaces);
  EXPECT_EQ(needed("sensor.depth.materials.min_return=0.01"), NeededTextures::surfaces);
  EXPECT_EQ(needed("", SensorPreset::kinect_v1), NeededTextures::surfaces);
  EXPECT_EQ(needed("sensor.preset=\"perfect\"", SensorPreset::kinect_v1), NeededTextures::alpha);
}

TEST(CameraJobs, NamesTheEffectsThatAnEquirectangularCameraCannotHave) {
  const auto refusal = [](const std::string& sensor, const RenderOptions& render = {}) {
    RigJob job = job_of(
        "[[camera]]\nname=\"p\"\nprojection=\"equirectangular\"\nwidth=64\nheight=32\n" + sensor);
    job.body.recipe.render = render;
    return error_text([&] { camera_jobs(job); });
  };
  for (const char* option :
       {"lens.blur=1.0", "lens.vignetting.k2=-0.1", "depth.offset=[0.1,0.0,0.0]",
        "depth.turn=[1.0,0.0,0.0]", "depth.normal.sigma=0.1", "depth.lateral.grazing=0.1",
        "depth.disparity.focal_baseline=9.0", "depth.flying.share=0.1",
        "depth.holes.second_view=0.1", "depth.holes.max_step=0.1", "depth.holes.edge_loss=0.1"}) {
    const std::string name = std::string(option).substr(0, std::string(option).find('='));
    const std::string effect = name.substr(0, name.rfind('.'));  // some messages name all of it
    EXPECT_THAT(refusal("sensor." + std::string(option)),
                testing::AllOf(HasSubstr("camera 'p': sensor: sensor." + effect),
                               HasSubstr("for projection = \"equirectangular\"")))
        << option;
  }
  EXPECT_THAT(refusal("sensor.depth.axial.constant=0.1\nsensor.depth.axial.correlation=2.0"),
              HasSubstr("sensor.depth.axial.correlation: is for pinhole cameras"));
  EXPECT_THAT(refusal("sensor.depth.holes.max_incidence_deg=80.0\n"
                      "sensor.depth.holes.correlation=1.0"),
              HasSubstr("sensor.depth.holes.correlation: is for pinhole cameras"));
  EXPECT_THAT(refusal("sensor.depth.multipath.frequency=2e8"),
              HasSubstr("sensor.depth.multipath.radius: is for pinhole cameras"));
  EXPECT_THAT(refusal("", {.kind = RendererKind::rasterizer}),
              HasSubstr("camera 'p': rasterizer: expected a pinhole camera"));
  EXPECT_EQ(refusal("sensor.depth.axial.constant=0.01\nsensor.depth.axial.grazing=0.01\n"
                    "sensor.depth.holes.max_incidence_deg=80.0\nsensor.depth.multipath.radius=0\n"
                    "sensor.depth.multipath.frequency=2e8\nsensor.depth.delay=0.01\n"
                    "sensor.shutter.readout_time=0.01\nsensor.jpeg.quality=80"),
            "no error");
}

constexpr const char* kInfrared = "spectrum=\"infrared\"";

std::string projector(const std::string& name, const std::string& rest) {
  return "[[projector]]\nname=\"" + name + "\"\nfov_deg=[90.0,90.0]\n" + rest + "\n";
}

TEST(CameraJobs, PatternsAreMadeOnlyWhereACameraSeesThem) {
  const std::string missing = projector("p", "pattern=\"missing.png\"");
  EXPECT_EQ(camera_jobs(job_of(camera("a") + missing)).size(), 1U);
  RigJob infrared = job_of(camera("a", kInfrared) + missing);
  EXPECT_THAT(error_text([&] { camera_jobs(infrared); }), HasSubstr("missing.png"));
  for (const RenderOptions& without :
       {RenderOptions{.mode = RenderMode::unlit}, RenderOptions{.mode = RenderMode::depth},
        RenderOptions{.kind = RendererKind::rasterizer}}) {
    infrared.body.recipe.render = without;
    EXPECT_TRUE(camera_jobs(infrared)[0].recipe.infrared.value().projectors.empty());
  }
}

/// Returns the image that a job's camera takes of a wall 2 m ahead of it, which a lamp lights.
cv::Mat image_of_wall(const RenderJob& job) {
  Scene scene;
  add(scene, square_at(2, 8), diffuse({0.9F, 0.6F, 0.3F}));
  scene.lights.push_back(point_light({0.5F, -1, 0}, {4, 4, 4}));
  const RenderersOverTime renderers(scene, {.samples = 1});
  const CameraTruth motion{job.recipe.truth, job.recipe.path};
  return SequenceCamera(scene, renderers, job.recipe.camera.model, motion, job.recipe.sensor,
                        job.recipe.infrared)
      .take(0)
      .image;
}

TEST(CameraJobs, ProjectorsAreSeenByInfraredCamerasAlone) {
  RigJob with = job_of(camera("color", "sensor.exposure=0.1") +
                       camera("grey", "spectrum=\"infrared\"\nsensor.exposure=0.1") +
                       projector("p", "power=20\ndots.number=50\ndots.diameter_deg=4.0"));
  with.body.recipe.truth = {{0, {}}};
  with.body.recipe.path = [](double) { return vo::SE3(); };
  RigJob without = with;
  without.rig.projectors.clear();
  const auto difference = [&](std::size_t number) {
    return cv::norm(image_of_wall(camera_jobs(with)[number]),
                    image_of_wall(camera_jobs(without)[number]), cv::NORM_INF);
  };
  EXPECT_EQ(difference(0), 0);
  EXPECT_GT(difference(1), 20);
}

TEST(CameraJobs, RefusesPatternsOfMorePixelsInAllThanFitIntoMemory) {
  std::string text = camera("a", kInfrared);
  const std::string widest = "dots.number=1\ndots.diameter_deg=0.112\n";  // 4093 x 4093 px
  for (const char* name : {"p", "q", "r", "s"}) {
    text += projector(name, widest);
  }
  EXPECT_EQ(camera_jobs(job_of(text))[0].recipe.infrared.value().projectors.size(), 4U);
  EXPECT_THAT(error_text([&] { camera_jobs(job_of(text + projector("t", widest))); }),
              HasSubstr("projector 't': pattern: expected at most 67108864 pixels"));
}

}  // namespace
}  // namespace synth
