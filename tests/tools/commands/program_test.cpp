#include "tests/support/program_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/instruction_sets.h"
#include "tests/support/plane_sequence.h"
#include "vo/core/fields.h"
#include "vo/files/input.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

class Program : public support::ProgramTest {
 protected:
  Program() { support::write_plane_sequence(file("sequence"), 6); }

  ProgramResult track(const std::string& rest) const {
    return run_program("track " + path("sequence") + " --quiet " + rest);
  }
};

TEST_F(Program, HelpTeachesAndIsNoError) {
  for (const char* command : {"", "render", "track", "evaluate", "run", "ablate"}) {
    const ProgramResult result = run_program(std::string(command) + " --help");
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_THAT(result.out, HasSubstr("edvo")) << command;
    EXPECT_EQ(result.err, "");
  }
  EXPECT_THAT(run_program("track --help").out, HasSubstr("map.references = 4"));
  EXPECT_THAT(run_program("track --help").out, HasSubstr("icl-nuim"));
}

TEST_F(Program, TrackPrintsItsContract) {
  const ProgramResult result = track("--out " + path("contract.txt") + " --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json summary = json::parse(result.out);
  EXPECT_EQ(summary["frames"], 6);
  EXPECT_EQ(summary["tracked_fraction"], 1.0);
  EXPECT_EQ(summary["keyframes"], 1) << "25 mm are less than a keyframe's flow";
  for (const char* key : {"median", "p90", "pyramid", "edges", "alignment"}) {
    EXPECT_GT(summary["ms_per_frame"][key], 0.0) << key;
  }
}

TEST_F(Program, EvaluatePrintsItsContract) {
  ASSERT_EQ(track("--out " + path("estimate.txt")).exit_code, 0);
  const std::string files = path("sequence/groundtruth.txt") + " " + path("estimate.txt");
  const ProgramResult result =
      run_program("evaluate " + files + " --interval 1f --json --sequence " + path("sequence"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json errors = json::parse(result.out);
  EXPECT_LT(errors["ate"]["rmse_m"], 2e-3) << "a tenth of a pixel is 1.5 mm";
  EXPECT_LT(errors["rpe"]["translation_rmse_m"], 2e-3);
  EXPECT_LT(errors["rpe"]["rotation_rmse_deg"], 0.1);
  for (const char* key : {"translation_mean_m", "translation_median_m", "translation_max_m",
                          "rotation_mean_deg", "rotation_median_deg", "rotation_max_deg"}) {
    EXPECT_TRUE(errors["rpe"].contains(key)) << key;
  }
  EXPECT_EQ(errors["scale"], 1.0);
  EXPECT_EQ(errors["matched_fraction"], 1.0);
  EXPECT_EQ(errors["tracked_fraction"], 1.0);
}

TEST_F(Program, AnEmptyValueIsNotTheDefault) {
  for (const char* option : {"--camera", "--depth-topic", "--out"}) {
    const ProgramResult result = track(std::string(option) + " ''");
    EXPECT_EQ(result.exit_code, 2) << option;
    EXPECT_THAT(result.err, HasSubstr(std::string(option) + ": is empty")) << option;
  }
  const ProgramResult homeless = run_program("cache list", "HOME= XDG_CACHE_HOME= ");
  EXPECT_EQ(homeless.exit_code, 3);
  EXPECT_THAT(homeless.err, HasSubstr("HOME is \"\", expected a folder's full path"));
}

TEST_F(Program, OptionsThatNothingUsesAreRefused) {
  write("poses.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  write("stamps.txt", "0\n1\n");
  const std::string poses = path("poses.txt");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"evaluate " + poses + " " + poses + " --times " + path("stamps.txt"),
       "--times: expected a trajectory without stamps"},
      {"convert " + poses + " " + path("out") + " --format kitti --times " + path("stamps.txt"),
       "--times: expected a trajectory without stamps"},
      {"convert " + poses + " " + path("out") + " --format tum --world y-up",
       "--world: expected a sequence, got a trajectory"},
      {"convert " + path("sequence") + " " + path("out") + " --format tum --points",
       "--points: expected --format mcap, got tum"},
      {"convert " + path("sequence") + " " + path("out") + " --format euroc --compression lz4",
       "--compression: expected --format mcap, got euroc"},
      {"convert " + path("sequence") + " " + path("out") + " --format tum --times " +
           path("stamps.txt"),
       "--times: expected a trajectory, got a sequence"}};
  for (const auto& [arguments, message] : cases) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(message)) << arguments;
    EXPECT_FALSE(exists("out")) << arguments;
  }
}

TEST_F(Program, ErrorsHaveNoControlCharacters) {
  const ProgramResult result = run_program("inspect \"$(printf 'a\\033[2Jb\\177')\"");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("a\\x1B[2Jb\\x7F"));
}

TEST_F(Program, APortIsNamedByTheOptionThatItIsOf) {
  write("page.txt", "0 0 0 0 0 0 0 1\n");
  EXPECT_THAT(run_program("view " + path("page.txt") + " --port 99999").err,
              HasSubstr("--port 99999: expected a port"));
  EXPECT_THAT(track("--out " + path("live.txt") + " --live=99999").err,
              HasSubstr("--live=99999: expected a port"));
}

TEST_F(Program, TwoRunsGiveTheSameBytesOnAnyNumberOfThreads) {
  ASSERT_EQ(track("--threads 1 --out " + path("one.txt")).exit_code, 0);
  ASSERT_EQ(track("--threads 2 --out " + path("two.txt")).exit_code, 0);
  EXPECT_EQ(read("one.txt"), read("two.txt"));
}

TEST_F(Program, TracksWhatConvertWrites) {
  ASSERT_EQ(track("--force --out " + path("tum.txt")).exit_code, 0);
  const vo::Trajectory expected = vo::read_trajectory(file("tum.txt"));
  for (const std::string format : {"euroc", "icl-nuim", "icl-tum"}) {
    ASSERT_EQ(run_program("convert " + path("sequence") + " " + path(format) +
                          " --quiet --format " + format)
                  .exit_code,
              0);
    const ProgramResult result =
        run_program("track " + path(format) + " --quiet --out " + path(format + ".txt"));
    ASSERT_EQ(result.exit_code, 0) << format << ": " << result.err;
    const vo::Trajectory poses = vo::read_trajectory(file(format + ".txt"));
    ASSERT_EQ(poses.size(), expected.size()) << format;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double distance =
          (poses[i].T_world_camera.translation() - expected[i].T_world_camera.translation()).norm();
      EXPECT_LT(distance, 1e-4) << format << ", frame " << i;  // m; depth is rounded to 0.2 mm
    }
  }
}

TEST_F(Program, AConfigurationRepeatsARunToTheByte) {
  ASSERT_EQ(track("--preset paper --set keyframes.every=3 --out " + path("set.txt")).exit_code, 0);
  ASSERT_EQ(
      track("--config " + path("set_config.toml") + " --out " + path("configured.txt")).exit_code,
      0);
  EXPECT_EQ(read("configured.txt"), read("set.txt"));
  EXPECT_EQ(read("configured_config.toml"), read("set_config.toml"));
  EXPECT_THAT(read("set_config.toml"), HasSubstr("preset = \"paper\"\n"));
  EXPECT_THAT(read("set_config.toml"), HasSubstr("keyframes.every = 3\n"));
}

TEST_F(Program, TheCommandLineCountsMoreThanAConfiguration) {
  write("some.toml", "preset = \"paper\"\nkeyframes.every = 2\n[align]\nmin_points = 50\n");
  ASSERT_EQ(track("--config " + path("some.toml") +
                  " --preset authors --set keyframes.every=4 --out " + path("both.txt"))
                .exit_code,
            0);
  const std::string config = read("both_config.toml");
  EXPECT_THAT(config, HasSubstr("preset = \"authors\"\n"));
  EXPECT_THAT(config, HasSubstr("keyframes.every = 4\n"));
  EXPECT_THAT(config, HasSubstr("align.min_points = 50\n"));
}

TEST_F(Program, AConfigurationThatCannotBeUsedIsNamedWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[keyframes]\nevry = 3\n",
       "bad.toml:2: unknown key 'keyframes.evry'; the nearest known key"},
      {"align.min_points = \"many\"\n", "bad.toml:1: align.min_points: expected"},
      {"preset = \"papr\"\n", "bad.toml:1: preset: expected one of paper, authors, default"},
      {"mode = [\n", "bad.toml:"}};
  for (const auto& [text, message] : cases) {
    write("bad.toml", text);
    const ProgramResult result =
        track("--config " + path("bad.toml") + " --out " + path("bad.txt"));
    EXPECT_EQ(result.exit_code, 3) << text;
    EXPECT_THAT(result.err, HasSubstr(message)) << text;
    EXPECT_FALSE(exists("bad.txt"));
  }
}

TEST_F(Program, EveryInstructionSetGivesTheSameBytes) {
  for (const std::string mode : {"rgbd", "mono --bootstrap rgbd"}) {
    std::string expected;
    for (const vo::InstructionSet set : support::instruction_sets_of_this_machine()) {
      const std::string name(vo::to_string<vo::InstructionSet>(set));
      const ProgramResult result =
          run_program("track " + path("sequence") + " --quiet --force --mode " + mode + " --out " +
                          path("set.txt"),
                      "EDVO_INSTRUCTION_SET=" + name + " ");
      ASSERT_EQ(result.exit_code, 0) << name << ": " << result.err;
      const std::string bytes = read("set.txt");
      expected = expected.empty() ? bytes : expected;
      EXPECT_EQ(bytes, expected) << mode << " with " << name;
    }
  }
}

TEST_F(Program, AnInstructionSetThatThereIsNotIsUsage) {
  const ProgramResult result = run_program("--version", "EDVO_INSTRUCTION_SET=sse9 ");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("EDVO_INSTRUCTION_SET: expected one of baseline, avx2"));
}

TEST_F(Program, MisspeltWordsAreNamedWithTheNearestOne) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"trak", "there is no command trak; the nearest is track"},
      {"track a --otu b", "there is no option --otu; the nearest is --out"},
      {"path chek", "there is no command chek; the nearest is check"},
      {"--colour", "there is no option --colour"},
      {"render scene.gltf --orbit.raduis=1", "; the nearest is --orbit.radius"},
      {"help trak", "there is no command trak; the nearest is track"}};
  for (const auto& [arguments, message] : cases) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(message)) << arguments;
  }
}

TEST_F(Program, HelpOfACommandIsItsHelp) {
  EXPECT_EQ(run_program("help track").out, run_program("track --help").out);
  EXPECT_EQ(run_program("help").out, run_program("--help").out);
  EXPECT_EQ(run_program("help path check").out, run_program("path check --help").out);
}

TEST_F(Program, DebugImagesLieBesideTheEstimate) {
  ASSERT_EQ(track("--debug-images 3 --out " + path("pictured.txt")).exit_code, 0);
  EXPECT_TRUE(exists("pictured_panels/000000.png"));
  EXPECT_TRUE(exists("pictured_panels/000003.png"));
  EXPECT_FALSE(exists("pictured_panels/000001.png"));
  EXPECT_TRUE(exists("pictured_trajectory.svg"));
}

TEST_F(Program, AWrongCommandLineIsUsage) {
  for (const char* arguments :
       {"", "tarck", "track", "evaluate a", "track a --out b --preset papre",
        "track a --out b --set keyframes.evry=1", "track a --out b --set keyframes.every=x",
        "evaluate a b --interval 3m", "render a --out b --path orbit --size 640",
        "render a --out b", "render a --out b --path orbit --intrinsics 1,2,3",
        "render a --out b --path orbit --fov 180", "path check a --path orbit --fov 180",
        "render a --out b --path orbit --rate -1", "track a --out b --set pyramid.levels=0"}) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments << "\n" << result.err;
    EXPECT_NE(result.err, "") << arguments;
    EXPECT_EQ(result.out, "") << arguments;
  }
  EXPECT_THAT(run_program("track a --out b --set keyframes.evry=1").err,
              HasSubstr("the nearest known key is keyframes.every"));
}

TEST_F(Program, ATimeDifferenceIsAtLeastZero) {
  EXPECT_EQ(track("--max-time-difference 0 --out " + path("equal.txt")).exit_code, 0);
  for (const std::string command :
       {"track a --out b", "evaluate a b", "depth a --out b", "record openni2 b"}) {
    for (const std::string value : {"nan", "-1", "inf", "x"}) {
      const ProgramResult result = run_program(command + " --max-time-difference=" + value);
      EXPECT_EQ(result.exit_code, 2) << command << value;
      EXPECT_THAT(result.err, HasSubstr("--max-time-difference")) << command << value;
    }
  }
}

TEST_F(Program, OptionsOfTheOtherModeAreRefused) {
  for (const std::string options :
       {"--mode mono --preset authors", "--bootstrap auto", "--depth-file d.png"}) {
    const ProgramResult result = track(options + " --out " + path("never.txt"));
    EXPECT_EQ(result.exit_code, 2) << options << result.err;
    EXPECT_THAT(result.err, HasSubstr("has no use for it")) << options;
  }
  EXPECT_FALSE(exists("never.txt"));
}

TEST_F(Program, UnusableInputIsNamed) {
  const std::string out = " --quiet --out " + path("never.txt");
  write("broken.toml", "widht = 64\n");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"track " + path("none") + out, "none: there is no such folder"},
      {"track " + path("sequence") + " --camera tum-fr9" + out, "the nearest preset is tum-fr"},
      {"track " + path("sequence") + " --camera tum-fr1" + out, "expected the camera's 640x480"},
      {"evaluate " + path("none.txt") + " " + path("none.txt"), "none.txt: there is no such file"},
      {"run " + path("none.toml") + " --out " + path("never"), "none.toml: there is no such file"},
      {"render " + path("none.gltf") + " --path orbit --out " + path("never"), "none.gltf"},
      {"render none.gltf --path orbit --camera " + path("broken.toml") + " --out " + path("never"),
       "broken.toml:1: unknown key 'widht'"},
      {"path check none.gltf --path orbit --camera " + path("broken.toml"), "broken.toml:1"},
      {"track " + path("sequence") + " --quiet --out /nowhere/e.txt", "there is no folder"}};
  for (const auto& [arguments, message] : cases) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 3) << arguments << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << "one sentence";
  }
  EXPECT_FALSE(exists("never.txt"));
  EXPECT_FALSE(has_leftovers());
}

TEST_F(Program, AnOutputThatDiffersIsKept) {
  write("kept.txt", "precious\n");
  EXPECT_EQ(track("--out " + path("kept.txt")).exit_code, 6);
  EXPECT_EQ(read("kept.txt"), "precious\n");
  EXPECT_EQ(track("--force --out " + path("kept.txt")).exit_code, 0);
  EXPECT_EQ(track("--out " + path("kept.txt")).exit_code, 0) << "the same again is no conflict";
}

TEST_F(Program, AFullDiskIsTemporaryAndLeavesNothing) {
  EXPECT_EQ(track("--out /dev/full").exit_code, 75);
  const ProgramResult result = run_program(
      "track " + path("sequence") + " --quiet --out " + path("full.txt"), "ulimit -f 0; ");
  EXPECT_NE(result.exit_code, 0);
  EXPECT_FALSE(exists("full.txt"));
  EXPECT_FALSE(has_leftovers());
}

TEST_F(Program, AResultThatStdoutCannotTakeIsNoSuccess) {
  ASSERT_EQ(track("--force --out " + path("e.txt")).exit_code, 0);
  const std::string files = path("sequence/groundtruth.txt") + " " + path("e.txt");
  EXPECT_EQ(run_program("evaluate " + files + " > /dev/full; exit $?; :").exit_code, 75);
  for (const char* help : {"--help", "--version", "render --help"}) {
    EXPECT_EQ(run_program(std::string(help) + " > /dev/full; exit $?; :").exit_code, 75) << help;
  }
}

TEST_F(Program, ATrajectoryCanGoDownAPipe) {
  const ProgramResult result = track("--json --out /dev/stdout | grep -vc '^#'");
  EXPECT_EQ(result.out, "6\n") << "poses alone; the summary is on stderr";
}

TEST_F(Program, AnIntervalWithoutPairsIsRefused) {
  ASSERT_EQ(track("--force --out " + path("e.txt")).exit_code, 0);
  const std::string files = path("sequence/groundtruth.txt") + " " + path("e.txt");
  const ProgramResult result = run_program("evaluate " + files + " --interval 100s --json");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("poses lie --interval 100s apart"));
  for (const std::string interval : {"0s", "-1s", "nans", "infs", "1.5f", "0f"}) {
    EXPECT_NE(run_program("evaluate " + files + " --interval " + interval).exit_code, 0)
        << interval;
  }
}

TEST_F(Program, ALostFrameIsSaidAndHasNoPose) {
  const fs::path covered = file("covered");
  support::write_plane_sequence(covered, 4);
  vo::write_file(covered / "rgb/000002.png",
                 vo::encode_png(cv::Mat(120, 160, CV_8UC1, cv::Scalar(90))),
                 vo::ExistingOutput::replace);
  const ProgramResult result =
      run_program("track " + path("covered") + " --quiet --json --out " + path("covered.txt") +
                  " --frame-log " + path("covered.csv"));
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_EQ(json::parse(result.out)["tracked_fraction"], 0.75);
  EXPECT_EQ(vo::read_trajectory(file("covered.txt")).size(), 3U);
  EXPECT_THAT(read("covered.csv"), HasSubstr("0.066667,lost,images_disagree,0"));
}

TEST_F(Program, ATruncatedImageNamesTheFileAndLeavesNothing) {
  const fs::path broken = file("broken");
  support::write_plane_sequence(broken, 3);
  const std::string bytes = vo::read_file(broken / "rgb/000002.png");
  vo::write_file(broken / "rgb/000002.png", bytes.substr(0, bytes.size() / 2),
                 vo::ExistingOutput::replace);
  const ProgramResult result = run_program("track " + path("broken") + " --quiet --out " +
                                           path("broken.txt") + " --debug-images 1");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("000002.png: cannot be decoded: it is truncated"));
  EXPECT_FALSE(exists("broken.txt"));
  EXPECT_FALSE(exists("broken_panels"));
  EXPECT_FALSE(has_leftovers());
}

}  // namespace
