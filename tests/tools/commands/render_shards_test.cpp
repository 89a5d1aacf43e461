#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/folder_contents.h"
#include "tests/support/gltf_document.h"
#include "tests/support/program.h"
#include "tests/support/render_room.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"
#include "vo/image_files/png.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::contents;
using support::ProgramResult;
using support::run_program;
using support::TempFolder;
using testing::HasSubstr;

ProgramResult render_shard(const fs::path& out, const std::string& options) {
  return support::render_room(out, "--duration 1 --size 32x24 --float-depth " + options);
}

TEST(RenderShards, GiveTheBytesOfOneRunInAnyOrderOnAnyNumberOfThreads) {
  const TempFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path shards = folder.path() / "shards";
  ASSERT_EQ(render_shard(whole, "--threads 1").exit_code, 0);
  for (const char* share : {"--shard 4/4 --threads 1", "--shard 3/4", "--shard 2/4 --threads 2"}) {
    EXPECT_EQ(render_shard(shards, share).exit_code, 0);
    EXPECT_FALSE(fs::exists(shards));
  }
  EXPECT_EQ(render_shard(shards, "--shard 1/4").exit_code, 0);
  EXPECT_EQ(contents(whole).size(), 3 * 6 + 6 + 1U);
  EXPECT_EQ(contents(whole), contents(shards));
  EXPECT_FALSE(fs::exists(shards.string() + ".part"));
}

/// Rolling shutter, blur, noise, a late depth camera, moving things, and every channel of truth.
TEST(RenderShards, GiveTheBytesOfOneRunWithAllEffectsAndChannels) {
  const TempFolder folder;
  const auto run = [&](const char* name, const std::string& share) {
    return run_program(
               std::string("render '") + EDVO_SOURCE_DIR +
               "/assets/moving_room/moving_room.gltf' --path pan --move.eye 0.8,1.4,1.2 "
               "--move.target 0,0.9,-1.5 --move.turn-deg 20 --move.ramp 0.2 "
               "--shake.amplitude 0.01 --rate 4 --duration 0.8 --size 32x24 --samples 4 "
               "--sensor kinect-v1 --channels all --imu.gyro-noise 0.001 --float-depth --quiet " +
               share + " --out '" + (folder.path() / name).string() + "'")
        .exit_code;
  };
  ASSERT_EQ(run("whole", "--threads 1"), 0);
  for (const char* share : {"--shard 4/4 --threads 2", "--shard 3/4 --threads 1",
                            "--shard 2/4 --threads 2", "--shard 1/4 --threads 1"}) {
    EXPECT_EQ(run("shards", share), 0) << share;
  }
  EXPECT_EQ(run("two_threads", "--threads 2"), 0);
  const auto whole = contents(folder.path() / "whole");
  EXPECT_GT(whole.size(), 4 * 10U);
  EXPECT_EQ(whole, contents(folder.path() / "shards"));
  EXPECT_EQ(whole, contents(folder.path() / "two_threads"));
}

TEST(RenderShards, DepthBeyond16BitIsCounted) {
  const TempFolder folder;
  const fs::path camera =
      folder.write("c.toml",
                   "width = 32\nheight = 24\nfx = 30.0\nfy = 30.0\ncx = 15.5\ncy = 11.5\n"
                   "depth_units_per_m = 30000.0\n");
  const ProgramResult result =
      run_program(std::string("render '") + EDVO_SOURCE_DIR +
                  "/assets/plane_and_box/plane_and_box.gltf' --path still --move.eye 0,0,2.2 "
                  "--move.target 0,0,0 --rate 1 --duration 0.5 --samples 1 --json --camera '" +
                  camera.string() + "' --out '" + (folder.path() / "s").string() + "'");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  // The plane is 2.2 m away, beyond 65534 / 30000; the box's front, 1.2 m away, covers the pixels
  // from 15.5 - 0.25 * 30 / 1.2 to the right and 0.375 * 30 / 1.2 up and down from 11.5.
  EXPECT_EQ(json::parse(result.out)["depth_beyond_16_bit"], 32 * 24 - 22 * 18);
  EXPECT_THAT(result.err, HasSubstr("depth pixels are beyond 2.18447 m"));
  EXPECT_THAT(vo::read_file(folder.path() / "s/sequence.toml"),
              HasSubstr("16 bit hold up to 2.18447 m"));
}

/// A triangle 2 m before the camera, in metres or, with a unit of 1000, in a file of millimetres.
ProgramResult render_triangle(const TempFolder& folder, const std::string& out, double unit,
                              const std::string& options) {
  synth::GltfDocument document = synth::triangle_document();
  document.json["nodes"][0]["scale"] = {4 * unit, 4 * unit, unit};
  document.json["nodes"][0]["translation"] = {-unit, -unit, -2 * unit};
  const fs::path scene = document.write(folder);
  return run_program("render '" + scene.string() +
                     "' --path still --move.eye 0,0,0 --move.target=0,0,-1 --rate 4 --duration 1 "
                     "--mode depth --size 32x24 --json " +
                     options + " --out '" + (folder.path() / out).string() + "'");
}

/// The share of pixels that are not 0 in the depth images of a folder.
double counted_coverage(const fs::path& folder) {
  double pixels = 0;
  double with_depth = 0;
  for (const auto& file : fs::directory_iterator(folder / "depth")) {
    const cv::Mat image = vo::read_png(file.path());
    pixels += static_cast<double>(image.total());
    with_depth += cv::countNonZero(image);
  }
  return with_depth / pixels;
}

TEST(RenderShards, DepthCoverageIsThatOfAllFramesThatAreThere) {
  const TempFolder folder;
  const ProgramResult part = render_triangle(folder, "s", 1, "--shard 1/2");
  ASSERT_EQ(part.exit_code, 0) << part.err;
  const double coverage = json::parse(part.out)["depth_coverage"];
  EXPECT_DOUBLE_EQ(coverage, counted_coverage(folder.path() / "s.part"));
  EXPECT_GT(coverage, 0.2);
  EXPECT_EQ(json::parse(part.out)["warning"], "");
  folder.write("s.part/depth/000000.png", "cut");
  const ProgramResult other = render_triangle(folder, "s", 1, "--frames 1:4");
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_NEAR(json::parse(other.out)["depth_coverage"], coverage, 1e-9)
      << "the camera stands still, and the damaged image does not count";
}

TEST(RenderShards, ASceneInMillimetresIsNamedWithWhatMendsIt) {
  const TempFolder folder;
  const ProgramResult millimetres = render_triangle(folder, "mm", 1000, "");
  ASSERT_EQ(millimetres.exit_code, 0) << millimetres.err;
  EXPECT_LT(json::parse(millimetres.out)["depth_coverage"], 0.2);
  EXPECT_THAT(millimetres.err, HasSubstr("--scene-scale 0.001"));
  const ProgramResult scaled = render_triangle(folder, "scaled", 1000, "--scene-scale 0.001");
  ASSERT_EQ(scaled.exit_code, 0) << scaled.err;
  ASSERT_EQ(render_triangle(folder, "metres", 1, "").exit_code, 0);
  EXPECT_EQ(contents(folder.path() / "scaled/depth"), contents(folder.path() / "metres/depth"));
  EXPECT_EQ(json::parse(scaled.out)["warning"], "");
}

TEST(RenderShards, FinishedFramesAreKeptAndMissingOnesMade) {
  const TempFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path out = folder.path() / "out";
  const fs::path part = folder.path() / "out.part";
  ASSERT_EQ(render_shard(whole, "").exit_code, 0);
  const ProgramResult first = render_shard(out, "--frames 1:4 --json");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(json::parse(first.out)["missing"], 3);
  EXPECT_EQ(json::parse(first.out)["folder"], part.string());
  fs::remove(part / "depth/000002.png");
  const ProgramResult second = render_shard(out, "--json");
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(json::parse(second.out)["rendered"], 4) << "frames 0, 2, 4 and 5";
  EXPECT_EQ(contents(whole), contents(out));
}

TEST(RenderShards, DamagedFilesAreMadeAgainAndNeverHandedOn) {
  const TempFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path out = folder.path() / "out";
  const fs::path part = folder.path() / "out.part";
  ASSERT_EQ(render_shard(whole, "").exit_code, 0);
  ASSERT_EQ(render_shard(out, "--shard 1/2").exit_code, 0);
  fs::resize_file(part / "depth_float/000000.npy", 0);
  std::string bytes = vo::read_file(part / "rgb/000001.png");
  bytes.back() = static_cast<char>(bytes.back() + 1);  // as long as before
  folder.write("out.part/rgb/000001.png", bytes);
  fs::remove(part / "edvo-done/000002.txt");  // as if copied without its record
  const ProgramResult second = render_shard(out, "--shard 2/2 --json");
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(json::parse(second.out)["missing"], 2) << "frames 0 and 2";
  const ProgramResult last = render_shard(out, "--json");
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(json::parse(last.out)["rendered"], 3) << "frames 0, 1 and 2";
  EXPECT_EQ(contents(whole), contents(out));
}

TEST(RenderShards, OfOneSequenceAtOnceShareItByFrames) {
  const TempFolder folder;
  ASSERT_EQ(render_shard(folder.path() / "whole", "").exit_code, 0);
  const std::string four_at_once =
      "sh -c 'for k in 1 2 3 4; do \"$0\" \"$@\" & p=\"$p $!\"; done; "
      "for q in $p; do wait $q || exit 9; done' ";
  const ProgramResult result = support::render_room(
      folder.path() / "out", "--duration 1 --size 32x24 --float-depth", four_at_once);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(contents(folder.path() / "whole"), contents(folder.path() / "out"));
  EXPECT_FALSE(support::has_leftovers(folder.path()));
}

TEST(RenderShards, FramesOfOtherInputsAreRefusedUnlessForced) {
  const TempFolder folder;
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(render_shard(out, "--frames 0:1").exit_code, 0);
  const ProgramResult refused = render_shard(out, "--ambient 0.5 --frames 1:2");
  EXPECT_EQ(refused.exit_code, 6);
  EXPECT_THAT(refused.err, HasSubstr("out.part: exists and differs"));
  EXPECT_EQ(
      json::parse(render_shard(out, "--ambient 0.5 --frames 1:2 --force --json").out)["missing"],
      5);
  EXPECT_FALSE(fs::exists(folder.path() / "out.part/rgb/000000.png"));
}

TEST(RenderShards, TerminationKeepsWholeFramesAndAsksForAnotherRun) {
  const TempFolder folder;
  const fs::path out = folder.path() / "out";
  const std::string once_a_frame_is_there =
      "sh -c '\"$0\" \"$@\" & until ls " + (folder.path() / "out.part/depth/").string() +
      "*.png || ! kill -0 $!; do sleep 0.05; done >/dev/null 2>&1; kill -TERM $!; wait $!' ";
  const ProgramResult result = run_program(
      std::string("render '") + EDVO_SOURCE_DIR +
          "/assets/room/room.gltf' --path orbit --duration 1000 --size 320x240 --quiet --out '" +
          out.string() + "'",
      once_a_frame_is_there);
  EXPECT_EQ(result.exit_code, 75) << result.err;
  EXPECT_THAT(result.err, HasSubstr("finished frames are kept in"));
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(contents(folder.path() / "out.part/rgb").size(),
            contents(folder.path() / "out.part/depth").size());
}

TEST(RenderShards, APlanTellsFramesBytesAndTimeAndWritesNothing) {
  const TempFolder folder;
  const fs::path out = folder.path() / "out";
  const ProgramResult result = render_shard(out, "--plan --json --shard 1/2");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::is_empty(folder.path()));
  const json plan = json::parse(result.out);
  EXPECT_EQ(plan["frames"], 3);
  EXPECT_EQ(plan["there"], 0);
  EXPECT_EQ(plan["files"], 9);
  EXPECT_GT(plan["cpu_s"], 0);
  ASSERT_EQ(render_shard(out, "--shard 1/2").exit_code, 0);
  double bytes = 0;
  for (const auto& [name, content] : contents(folder.path() / "out.part")) {
    const bool is_of_a_frame = name.starts_with("rgb/") || name.starts_with("depth");
    bytes += is_of_a_frame ? static_cast<double>(content.size()) : 0;
  }
  EXPECT_EQ(plan["bytes"], bytes) << "all three frames were measured";
  EXPECT_EQ(json::parse(render_shard(out, "--plan --json").out)["there"], 3);
}

TEST(RenderShards, AShareThatIsNoneIsAnErrorOfTheCommandLine) {
  const TempFolder folder;
  for (const char* share : {"--shard 0/4", "--shard 5/4", "--frames 3:2", "--frames 0:7"}) {
    EXPECT_EQ(render_shard(folder.path() / "out", share).exit_code, 2) << share;
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
