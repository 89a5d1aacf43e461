#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/plane_sequence.h"
#include "tests/support/program_test.h"

namespace {

using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

/// A sequence with its trajectory in a file, to compare with what streams give.
class Streams : public support::ProgramTest {
 protected:
  Streams() {
    support::write_plane_sequence(file("sequence"), 6);
    run_program(track("--out " + path("e.txt") + " --frame-log " + path("e.csv")));
  }

  std::string track(const std::string& rest) const {
    return "track " + path("sequence") + " --quiet " + rest;
  }

  /// Runs the program with a file as its stdin, through a pipe.
  ProgramResult piped(const std::string& name, const std::string& arguments) const {
    return run_program(arguments, "cat " + path(name) + " | ");
  }
};

TEST_F(Streams, EvaluateReadsEitherTrajectoryFromStdin) {
  const std::string truth = path("sequence/groundtruth.txt");
  const ProgramResult files = run_program("evaluate " + truth + " " + path("e.txt"));
  ASSERT_EQ(files.exit_code, 0) << files.err;
  const ProgramResult estimate = piped("e.txt", "evaluate " + truth + " -");
  EXPECT_EQ(estimate.exit_code, 0) << estimate.err;
  EXPECT_EQ(estimate.out, files.out);
  EXPECT_EQ(piped("sequence/groundtruth.txt", "evaluate - " + path("e.txt")).out, files.out);
  EXPECT_EQ(run_program("evaluate " + truth + " - <" + path("e.txt")).out, files.out);
}

TEST_F(Streams, TrackWritesTheBytesOfTheFileToStdout) {
  const ProgramResult poses = run_program(track("--out -"));
  ASSERT_EQ(poses.exit_code, 0) << poses.err;
  EXPECT_EQ(poses.out, read("e.txt"));
  EXPECT_THAT(poses.err, HasSubstr("6 of 6 frames tracked"));
  const ProgramResult log = run_program(track("--force --frame-log - --out " + path("e.txt")));
  EXPECT_EQ(log.out, read("e.csv"));
  EXPECT_THAT(log.err, HasSubstr("6 of 6 frames tracked"));
}

TEST_F(Streams, StdoutIsAppendedToWhereTheShellSaysSo) {
  write("log", "first\n");
  ASSERT_EQ(run_program("--version", "'" + std::string(EDVO_PROGRAM) + "' " + track("--out -") +
                                         " >>" + path("log") + " && ")
                .exit_code,
            0);
  EXPECT_EQ(read("log"), "first\n" + read("e.txt"));
}

TEST_F(Streams, ConfigurationAndCameraComeFromStdin) {
  ASSERT_EQ(run_program(track("--set keyframes.every=3 --out " + path("set.txt"))).exit_code, 0);
  const ProgramResult configured = piped("set_config.toml", track("--config - --out -"));
  EXPECT_EQ(configured.out, read("set.txt")) << configured.err;
  EXPECT_EQ(piped("sequence/camera.toml", track("--camera - --out -")).out, read("e.txt"));
}

TEST_F(Streams, OneOfEachAtMost) {
  for (const std::string& arguments :
       {std::string("evaluate - -"), track("--camera - --config - --out x"),
        track("--out - --frame-log -"), track("--json --out -"), track("--json - --out -"),
        std::string("compare - -")}) {
    const ProgramResult result = piped("e.txt", arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr("expected at most one")) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
  }
}

TEST_F(Streams, TwoOutputsAreTwoFiles) {
  std::filesystem::create_directory(file("folder"));
  for (const std::string other : {"twice", "folder/../twice"}) {
    const ProgramResult result =
        run_program(track("--out " + path("twice") + " --frame-log " + path(other)));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("twice is written by --out already, expected another file"));
    EXPECT_FALSE(exists("twice"));
  }
  EXPECT_EQ(run_program("test --json F --junit G --report F").exit_code, 2);
}

TEST_F(Streams, AnOutputIsNoInput) {
  write("z.toml", "why = \"mine\"");
  std::filesystem::create_symlink("z.toml", file("link.toml"));
  const std::string camera = path("sequence/camera.toml");
  const std::string truth = path("sequence/groundtruth.txt");
  std::vector<std::string> lines{
      "test " + path("z.toml") + " --json " + path("link.toml"),
      "test " + path("") + " --json " + path("z.toml"),
      "test x.toml --save-baseline " + path("z.toml") + " --baseline " + path("z.toml") +
          " --junit " + path("z.toml"),
      track("--force --camera " + camera + " --out " + camera),
      "evaluate " + truth + " " + path("e.txt") + " --force --evo-ape " + path("e.txt"),
      "convert --force --format tum " + path("e.txt") + " " + path("e.txt")};
  for (const std::string name : {"rgb.txt", "depth.txt", "groundtruth.txt", "sequence.toml"}) {
    lines.push_back(track("--force --out " + path("sequence/" + name)));
  }
  const std::string estimate = read("e.txt");
  for (const std::string& line : lines) {
    const ProgramResult result = run_program(line);
    EXPECT_EQ(result.exit_code, 2) << line << result.err;
    EXPECT_THAT(result.err, HasSubstr(", expected another file")) << line;
  }
  EXPECT_EQ(read("z.toml"), "why = \"mine\"");
  EXPECT_EQ(read("e.txt"), estimate);
  EXPECT_THAT(read("sequence/rgb.txt"), HasSubstr(".png"));
}

TEST_F(Streams, AnOutputMayLieBesideASequencesFiles) {
  EXPECT_EQ(run_program(track("--out " + path("sequence/e.txt"))).exit_code, 0);
  const std::string again = track("--force --config " + path("sequence/e_config.toml") + " --out " +
                                  path("sequence/e.txt"));
  EXPECT_EQ(run_program(again).exit_code, 0) << "the options are what they were";
  EXPECT_EQ(read("sequence/e.txt"), read("e.txt"));
}

TEST_F(Streams, WhatIsWrittenBesideAnOutputIsNoOtherOutput) {
  for (const std::string& rest :
       {"--frame-log " + path("new_config.toml"), "--time-log " + path("new_config.toml"),
        "--debug-images 5 --frame-log " + path("new_panels"),
        "--debug-images 5 --frame-log " + path("new_trajectory.svg"),
        "--camera " + path("new_config.toml")}) {
    write("new_config.toml", "");
    const ProgramResult result =
        run_program(track("--force --out " + path("new.txt") + " " + rest));
    EXPECT_EQ(result.exit_code, 2) << rest << result.err;
    EXPECT_FALSE(exists("new.txt")) << rest;
  }
  EXPECT_EQ(
      run_program(track("--force --out " + path("new.txt") + " --frame-log " + path("new_panels")))
          .exit_code,
      0)
      << "no pictures are asked for";
}

TEST_F(Streams, ALinkToAnOutputThatIsNotThereYetIsThatOutput) {
  std::filesystem::create_symlink("new.txt", file("log.csv"));
  const ProgramResult result =
      run_program(track("--force --out " + path("new.txt") + " --frame-log " + path("log.csv")));
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_FALSE(exists("new.txt"));
}

TEST_F(Streams, AreRefusedWhereTheyMakeNoSense) {
  for (const std::string& arguments :
       {std::string("track - --out x"), std::string("render room.gltf --path still --out -"),
        std::string("convert - x --format tum"), track("--debug-images 2 --out -")}) {
    const ProgramResult result = run_program(arguments + " </dev/null");
    EXPECT_EQ(result.exit_code, 2) << arguments << result.err;
    EXPECT_EQ(result.out, "") << arguments;
  }
  const ProgramResult scene = run_program("inspect - <'" EDVO_SOURCE_DIR "/assets/room/room.gltf'");
  EXPECT_EQ(scene.exit_code, 3);
  EXPECT_THAT(scene.err, HasSubstr("no folder when it is read from a stream; expected a .glb"));
}

TEST_F(Streams, ASceneOfOneFileIsReadFromStdin) {
  write("empty.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"name": "hall"}]})");
  const ProgramResult scene = run_program("inspect " + path("empty.gltf"));
  ASSERT_EQ(scene.exit_code, 0) << scene.err;
  EXPECT_THAT(scene.out, HasSubstr("hall"));
  EXPECT_EQ(piped("empty.gltf", "inspect -").out, scene.out);
}

TEST_F(Streams, AFileMayBeCalledLikeThem) {
  write("-", read("e.txt"));
  const std::string arguments = "evaluate " + path("sequence/groundtruth.txt") + " ";
  EXPECT_EQ(run_program(arguments + "./-", "cd " + path("") + " && ").out,
            run_program(arguments + path("e.txt")).out);
}

TEST_F(Streams, AnErrorNamesTheStreamAndItsLine) {
  write("bad.txt", "1 2\n");
  const ProgramResult bad = piped("bad.txt", "evaluate " + path("e.txt") + " -");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_THAT(bad.err, HasSubstr("/dev/stdin:1: expected the 8 values"));
  const ProgramResult closed = run_program("evaluate " + path("e.txt") + " - <&-");
  EXPECT_EQ(closed.exit_code, 3);
  EXPECT_THAT(closed.err, HasSubstr("/dev/stdin: is closed"));
}

TEST_F(Streams, NoFileBecomesAStreamThatIsClosed) {
  const std::string convert = "convert " + path("sequence") + " --format mcap ";
  ASSERT_EQ(run_program(convert + path("open.mcap")).exit_code, 0);
  for (const std::string closed : {"0<&-", "1>&-", "2>&-", "0<&- 1>&- 2>&-"}) {
    run_program("--version", "'" + std::string(EDVO_PROGRAM) + "' " + convert +
                                 path("closed.mcap") + " >/dev/null 2>/dev/null " + closed + "; ");
    EXPECT_EQ(read("closed.mcap"), read("open.mcap")) << closed;
    std::filesystem::remove(file("closed.mcap"));
  }
}

TEST_F(Streams, AScenarioFromStdinIsAsIfItLayInTheWorkingFolder) {
  write_scenario("good", "1");
  const std::string rest = " --json --quiet --debug-images 0 --out ";
  const ProgramResult of_file =
      run_program("run " + path("scenarios/good.toml") + rest + path("a"));
  ASSERT_EQ(of_file.exit_code, 0) << of_file.err;
  const ProgramResult of_stream =
      run_program("run - <good.toml" + rest + path("b"), "cd " + path("scenarios") + " && ");
  ASSERT_EQ(of_stream.exit_code, 0) << of_stream.err;
  EXPECT_EQ(read("b/trajectory.txt"), read("a/trajectory.txt"));
  EXPECT_EQ(nlohmann::json::parse(of_stream.out)["scenario"], "stdin");
}

TEST_F(Streams, ResultsGoToStdoutAndTheTableToStderr) {
  write_scenario("good", "1");
  const std::string test = "test --quiet --cache " + path("cache") + " " + path("scenarios");
  ASSERT_EQ(run_program(test + " --json " + path("r.json") + " --junit " + path("j.xml")).exit_code,
            0);
  const ProgramResult junit = run_program(test + " --junit -");
  EXPECT_THAT(junit.out, HasSubstr("<testsuite"));
  EXPECT_THAT(junit.err, HasSubstr("PASS  1 scenarios"));
  const ProgramResult compared = piped("r.json", "compare - " + path("r.json"));
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_EQ(compared.out, run_program("compare " + path("r.json") + " " + path("r.json")).out);
  EXPECT_EQ(piped("r.json", test + " --baseline -").exit_code, 0);
}

TEST_F(Streams, AClosedPipeEndsTheProgramWithoutAWord) {
  for (const std::string ignored : {"", "trap '' PIPE; "}) {
    write("code", "");
    // The writer starts once its reader has gone: it waits for the end of the process that held it.
    const std::string before = ignored + "mkfifo " + path("pipe") + "; (exec 3<" + path("pipe") +
                               ") & exec 4>" + path("pipe") + "; wait; ";
    const ProgramResult result = run_program(
        track("--out - >&4 2>" + path("err") + "; echo $? >" + path("code") + "; true"), before);
    EXPECT_EQ(read("code"), "141\n") << ignored << result.err;
    EXPECT_EQ(read("err"), "");
    std::filesystem::remove(file("pipe"));
  }
}

}  // namespace
