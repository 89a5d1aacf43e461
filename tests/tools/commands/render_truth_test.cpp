#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/folder_contents.h"
#include "tests/support/program.h"
#include "tests/support/render_room.h"
#include "tests/support/temp_folder.h"
#include "vo/dataset/sequence.h"
#include "vo/files/input.h"
#include "vo/image_files/float_image.h"
#include "vo/image_files/flow_file.h"
#include "vo/text_files/toml_file.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::contents;
using support::ProgramResult;
using support::run_program;
using support::TempFolder;
using testing::HasSubstr;

ProgramResult render_truth(const fs::path& out, const std::string& options) {
  return support::render_room(out, "--duration 0.4 --size 64x48 " + options);
}

TEST(RenderTruth, TheManifestIsTomlWithOneHashPerChannelOfMotion) {
  const TempFolder folder;
  for (const char* channels : {"imu", "velocity", "all"}) {
    const fs::path out = folder.path() / channels;
    const ProgramResult result = render_truth(out, std::string("--channels ") + channels);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::vector<vo::TomlValue> values = vo::read_toml(out / "sequence.toml");
    const auto hashes = std::count_if(values.begin(), values.end(), [](const auto& value) {
      return value.key.starts_with("motion_hash.");
    });
    EXPECT_EQ(hashes, std::string(channels) == "all" ? 2 : 1) << channels;
  }
}

TEST(RenderTruth, EveryChannelIsThereAndItsConventionInTheManifest) {
  const TempFolder folder;
  const fs::path out = folder.path() / "s";
  const ProgramResult result = render_truth(out, "--channels all --float-format tiff");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string manifest = vo::read_file(out / "sequence.toml");
  for (const char* channel : {"depth", "normal", "instance", "material", "flow", "occlusion",
                              "edges", "moving", "velocity", "imu"}) {
    EXPECT_THAT(manifest, HasSubstr(std::string("\ntruth.") + channel + " = ")) << channel;
  }
  for (const char* file :
       {"depth/000002.tiff", "normal/000002.tiff", "instance/000002.png", "material/000002.png",
        "flow/000001.flo", "occlusion/000001.png", "edges/000002.png", "moving/000002.png",
        "velocity.csv", "imu_states.csv"}) {
    EXPECT_TRUE(fs::exists(out / "truth" / file)) << file;
  }
  EXPECT_FALSE(fs::exists(out / "truth/flow/000002.flo")) << "there is no frame after the last";
  EXPECT_TRUE(fs::exists(out / "imu.csv"));
}

TEST(RenderTruth, FlowAgreesWithDepthAndPoseOnDisk) {
  const TempFolder folder;
  const fs::path out = folder.path() / "s";
  ASSERT_EQ(render_truth(out, "--channels depth,flow").exit_code, 0);
  const vo::SequenceReader sequence(out);
  const vo::PinholeCamera& camera = sequence.camera().pinhole;
  const vo::DepthImage depth = vo::read_float_image(out / "truth/depth/000000.npy");
  const auto flow = vo::read_flow(out / "truth/flow/000000.flo");
  const vo::Trajectory& truth = sequence.ground_truth();
  const vo::SE3 T_next_now = truth[1].T_world_camera.inverse() * truth[0].T_world_camera;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d p_next = T_next_now * camera.unproject({u, v}, depth(v, u));
      const Eigen::Vector2d target = camera.project(p_next);
      EXPECT_LT(std::hypot(flow(v, u)[0] - (target.x() - u), flow(v, u)[1] - (target.y() - v)),
                0.01)
          << "px at " << u << ", " << v;
    }
  }
}

TEST(RenderTruth, ShardsGiveTheBytesOfOneRun) {
  const TempFolder folder;
  const std::string channels = "--channels all --imu.gyro-noise 0.01 --imu.accel-bias-walk 0.1 ";
  ASSERT_EQ(render_truth(folder.path() / "whole", channels + "--threads 1").exit_code, 0);
  ASSERT_EQ(render_truth(folder.path() / "shards", channels + "--shard 2/2").exit_code, 0);
  ASSERT_EQ(render_truth(folder.path() / "shards", channels + "--shard 1/2").exit_code, 0);
  EXPECT_EQ(contents(folder.path() / "whole"), contents(folder.path() / "shards"));
}

TEST(RenderTruth, AnUnknownChannelIsAnErrorOfTheCommandLine) {
  const TempFolder folder;
  const ProgramResult result = render_truth(folder.path() / "s", "--channels depth,flwo");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("flwo"));
  EXPECT_EQ(render_truth(folder.path() / "s", "--channels depth,depth").exit_code, 2);
}

TEST(ConvertProgram, ASequenceComesBackFromEveryFormat) {
  const TempFolder folder;
  const fs::path tum = folder.path() / "tum";
  ASSERT_EQ(render_truth(tum, "").exit_code, 0);
  const vo::SequenceReader expected(tum);
  for (const std::string format : {"euroc", "icl-nuim", "icl-tum", "tartanair"}) {
    const fs::path there = folder.path() / format;
    const fs::path back = folder.path() / (format + "_back");
    const ProgramResult result = run_program("convert '" + tum.string() + "' '" + there.string() +
                                             "' --quiet --json --format " + format);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(json::parse(result.out)["frames"], 3);
    EXPECT_EQ(json::parse(result.out)["depth_beyond_16_bit"], 0);
    ASSERT_EQ(run_program("convert '" + there.string() + "' '" + back.string() +
                          "' --quiet --format tum --world y-up")
                  .exit_code,
              0);
    const vo::SequenceReader copy(back);
    ASSERT_EQ(copy.size(), 3U);
    for (const std::size_t i : {0U, 1U, 2U}) {
      EXPECT_EQ(cv::norm(copy.read(i).image, expected.read(i).image, cv::NORM_INF), 0) << format;
      EXPECT_LT(cv::norm(copy.read(i).depth, expected.read(i).depth, cv::NORM_INF), 1e-6) << format;
      EXPECT_LT((copy.ground_truth()[i].T_world_camera.inverse() *
                 expected.ground_truth()[i].T_world_camera)
                    .log()
                    .norm(),
                1e-8)
          << format;
    }
  }
}

TEST(ConvertProgram, BadInputIsToldAndNothingIsWritten) {
  const TempFolder folder;
  const std::string out = "' '" + (folder.path() / "out").string() + "' --format ";
  folder.write("in/readme", "nothing");
  const std::string in = "convert '" + (folder.path() / "in").string() + out;
  EXPECT_EQ(run_program(in + "7-scenes").exit_code, 2);
  const ProgramResult result = run_program(in + "tum");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("holds no sequence that is known"));
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

}  // namespace
