
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/support/temp_folder.h"
#include "vo/dataset/sequence.h"
#include "vo/files/npy.h"
#include "vo/files/png.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using support::TempFolder;
using testing::HasSubstr;

const std::string kRoom = std::string("'") + EDVO_SOURCE_DIR + "/assets/room/room.gltf'";

constexpr const char* kOrbit =
    " --path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 4 "
    "--duration 0.5 --size 64x48 --samples 1 --quiet";

constexpr const char* kRenderScenario = R"(why = "it is broken"
[scene]
gltf = "room/room.gltf"
[camera]
width = 160
height = 120
[path]
kind = "orbit"
rate = 30.0
duration = 0.2
orbit.centre = [-0.95, 0.5, 0.3]
orbit.radius = 1.2
orbit.height = 0.8
[expect]
tracked_fraction = { min = 1.0 }
ate_rmse_m.max = LIMIT
)";

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

/// A scenario file in a folder whose sibling `assets` is the project's.
fs::path write_scenario(const TempFolder& folder, const std::string& limit) {
  std::string text = kRenderScenario;
  text.replace(text.find("LIMIT"), 5, limit);
  if (!fs::exists(folder.path() / "assets")) {
    fs::create_directory_symlink(fs::path(EDVO_SOURCE_DIR) / "assets", folder.path() / "assets");
  }
  return folder.write("scenarios/small.toml", text);
}

TEST(RenderProgram, WritesASequenceThatReadsBack) {
  const TempFolder folder;
  const fs::path out = folder.path() / "sequence";
  const ProgramResult result =
      run_program("render " + kRoom + kOrbit + " --float-depth --json --out " + quoted(out));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["frames"], 3);
  const vo::SequenceReader sequence(out);
  ASSERT_EQ(sequence.size(), 3U);
  EXPECT_EQ(sequence.ground_truth().size(), 3U);
  const vo::DepthImage exact = vo::read_npy(out / "depth_float/000001.npy");
  EXPECT_LE(cv::norm(sequence.read(1).depth, exact, cv::NORM_INF), 0.5 / 5000 + 1e-6);
  EXPECT_THAT(vo::read_file(out / "sequence.toml"), HasSubstr("render.samples = 1"));
}

TEST(RenderProgram, GivesTheSameBytesOnAnyNumberOfThreads) {
  const TempFolder folder;
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(run_program("render " + kRoom + kOrbit + " --threads " + threads + " --out " +
                          quoted(folder.path() / threads))
                  .exit_code,
              0);
  }
  for (const char* file : {"rgb/000002.png", "depth/000002.png", "sequence.toml", "rgb.txt"}) {
    EXPECT_EQ(vo::read_file(folder.path() / "1" / file), vo::read_file(folder.path() / "2" / file));
  }
}

TEST(RenderProgram, UsesTheSameSequenceAgainAndKeepsAnother) {
  const TempFolder folder;
  const std::string render =
      "render " + kRoom + kOrbit + " --json --out " + quoted(folder.path() / "s");
  ASSERT_EQ(run_program(render).exit_code, 0);
  const ProgramResult again = run_program(render);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(json::parse(again.out)["was_there"], true);
  EXPECT_EQ(run_program(render + " --ambient 0.5").exit_code, 6);
  EXPECT_EQ(run_program(render + " --ambient 0.5 --force").exit_code, 0);
}

TEST(RenderProgram, AFullDiskLeavesNothingUnderTheFinalName) {
  const TempFolder folder;
  const fs::path out = folder.path() / "s";
  const ProgramResult result =
      run_program("render " + kRoom + kOrbit + " --out " + quoted(out), "ulimit -f 2; ");
  EXPECT_EQ(result.exit_code, 75) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot be written: File too large"));
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(support::has_leftovers(folder.path()));
}

TEST(RenderProgram, AnInterruptLeavesNothingUnderTheFinalName) {
  const TempFolder folder;
  const fs::path out = folder.path() / "s";
  const ProgramResult result = run_program(
      "render " + kRoom + " --path orbit --duration 60 --samples 1 --quiet --out " + quoted(out),
      "timeout --preserve-status --signal=INT 2 ");
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(support::has_leftovers(folder.path()));
}

TEST(RunProgram, PassesFailsAndKeepsItsPromises) {
  const TempFolder folder;
  const fs::path out = folder.path() / "result";
  const std::string run = "run " + quoted(write_scenario(folder, "0.01")) + " --quiet --out " +
                          quoted(out) + " --debug-images 5";
  const ProgramResult result = run_program(run);
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("PASS  2 of 2 bounds"));
  for (const char* file : {"report.md", "report.json", "trajectory.svg", "trajectory.txt",
                           "frames.csv", "panels/000005.png", "sequence/groundtruth.txt"}) {
    EXPECT_TRUE(fs::exists(out / file)) << file;
  }
  EXPECT_EQ(run_program(run).exit_code, 0) << "the same again";
  write_scenario(folder, "1e-9");
  EXPECT_EQ(run_program(run).exit_code, 6) << "another report";
  const ProgramResult failed = run_program(run + " --force");
  EXPECT_EQ(failed.exit_code, 4);
  EXPECT_THAT(failed.out, HasSubstr("VIOLATED"));
}

TEST(RunProgram, LeavesAFolderOfSomebodyElseAlone) {
  const TempFolder folder;
  const std::string run = "run " + quoted(write_scenario(folder, "0.01")) + " --quiet --out " +
                          quoted(folder.path() / "mine");
  folder.write("mine/report.md", "precious");
  const ProgramResult result = run_program(run + " --force");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("holds other files than edvo's"));
  EXPECT_EQ(vo::read_file(folder.path() / "mine/report.md"), "precious");
  fs::rename(folder.path() / "mine/report.md", folder.path() / "mine/.panels.partial-1");
  EXPECT_EQ(run_program(run).exit_code, 0) << "what a killed run leaves is no obstacle";
}

TEST(RunProgram, NamesFileAndLineOfAnUnknownKey) {
  const TempFolder folder;
  const fs::path file = write_scenario(folder, "0.01\nkeyfarmes.min = 1");
  const ProgramResult result =
      run_program("run " + quoted(file) + " --out " + quoted(folder.path() / "r"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("small.toml:17: unknown key"));
  EXPECT_FALSE(fs::exists(folder.path() / "r"));
}

}  // namespace
