
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/folder_contents.h"
#include "tests/support/gltf_document.h"
#include "tests/support/program_test.h"
#include "vo/dataset/sequence.h"
#include "vo/files/input.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

const std::string kRoom = std::string("'") + EDVO_SOURCE_DIR + "/assets/room/room.gltf'";

constexpr const char* kOrbit =
    " --path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 4 "
    "--duration 0.5 --size 64x48 --samples 1 --quiet";

using RenderProgram = support::ProgramTest;
using RunProgram = support::ProgramTest;

TEST_F(RenderProgram, WritesASequenceThatReadsBack) {
  const fs::path out = file("sequence");
  const ProgramResult result =
      run_program("render " + kRoom + kOrbit + " --float-depth --json --out " + path("sequence"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["frames"], 3);
  const vo::SequenceReader sequence(out);
  ASSERT_EQ(sequence.size(), 3U);
  EXPECT_EQ(sequence.ground_truth().size(), 3U);
  const vo::DepthImage exact = vo::read_npy(out / "depth_float/000001.npy");
  EXPECT_LE(cv::norm(sequence.read(1).depth, exact, cv::NORM_INF), 0.5 / 5000 + 1e-6);
  EXPECT_THAT(vo::read_file(out / "sequence.toml"), HasSubstr("render.samples = 1"));
}

TEST_F(RenderProgram, GivesTheSameBytesOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(run_program("render " + kRoom + kOrbit + " --threads " + threads + " --out " +
                          path(threads))
                  .exit_code,
              0);
  }
  for (const char* name : {"rgb/000002.png", "depth/000002.png", "sequence.toml", "rgb.txt"}) {
    EXPECT_EQ(read(std::string("1/") + name), read(std::string("2/") + name));
  }
}

TEST_F(RenderProgram, UsesTheSameSequenceAgainAndKeepsAnother) {
  const std::string render = "render " + kRoom + kOrbit + " --json --out " + path("s");
  ASSERT_EQ(run_program(render).exit_code, 0);
  const ProgramResult again = run_program(render);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(json::parse(again.out)["was_there"], true);
  EXPECT_EQ(run_program(render + " --ambient 0.5").exit_code, 6);
  EXPECT_EQ(run_program(render + " --ambient 0.5 --force").exit_code, 0);
}

TEST_F(RenderProgram, AFullDiskLeavesNothingUnderTheFinalName) {
  const ProgramResult result =
      run_program("render " + kRoom + kOrbit + " --out " + path("s"), "ulimit -f 2; ");
  EXPECT_EQ(result.exit_code, 75) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot be written: File too large"));
  EXPECT_FALSE(exists("s"));
  EXPECT_FALSE(has_leftovers());
}

TEST_F(RenderProgram, AnInterruptLeavesNothingUnderTheFinalName) {
  const ProgramResult result = run_program(
      "render " + kRoom + " --path orbit --duration 60 --samples 1 --quiet --out " + path("s"),
      "timeout --preserve-status --signal=INT 2 ");
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_FALSE(exists("s"));
  EXPECT_FALSE(has_leftovers());
}

TEST_F(RunProgram, PassesFailsAndKeepsItsPromises) {
  write_scenario("small", "0.01");
  const std::string run = "run " + path("scenarios/small.toml") + " --quiet --out " +
                          path("result") + " --debug-images 5";
  const ProgramResult result = run_program(run);
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("PASS  2 of 2 bounds"));
  for (const char* name : {"report.md", "report.json", "trajectory.svg", "trajectory.txt",
                           "frames.csv", "panels/000005.png", "sequence/groundtruth.txt"}) {
    EXPECT_TRUE(exists(std::string("result/") + name)) << name;
  }
  EXPECT_EQ(run_program(run).exit_code, 0) << "the same again";
  write_scenario("small", "1e-9");
  EXPECT_EQ(run_program(run).exit_code, 6) << "another report";
  const ProgramResult failed = run_program(run + " --force");
  EXPECT_EQ(failed.exit_code, 4);
  EXPECT_THAT(failed.out, HasSubstr("VIOLATED"));
}

TEST_F(RunProgram, LeavesAFolderOfSomebodyElseAlone) {
  write_scenario("small", "0.01");
  const std::string run = "run " + path("scenarios/small.toml") + " --quiet --out " + path("mine");
  write("mine/report.md", "precious");
  const ProgramResult result = run_program(run + " --force");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("holds other files than edvo's"));
  EXPECT_EQ(read("mine/report.md"), "precious");
  fs::rename(file("mine/report.md"), file("mine/.panels.partial-1"));
  EXPECT_EQ(run_program(run).exit_code, 0) << "what a killed run leaves is no obstacle";
}

TEST_F(RunProgram, GoesOnWhereItWasKilledWhileItRendered) {
  write_scenario("small", "0.01");
  const std::string run = "run " + path("scenarios/small.toml") + " --quiet --out ";
  ASSERT_EQ(run_program(run + path("whole")).exit_code, 0);
  fs::create_directories(file("killed"));
  fs::copy(file("whole/sequence"), file("killed/sequence.part"), fs::copy_options::recursive);
  fs::create_directory(file("killed/sequence.part/edvo-done"));  // as nothing finished has it
  fs::remove(file("killed/sequence.part/rgb/000001.png"));
  const ProgramResult result = run_program(run + path("killed"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(support::contents(file("whole")), support::contents(file("killed")));
}

TEST_F(RunProgram, GoesOnWhereItWasKilledWhileItReplacedASequence) {
  write_scenario("small", "0.01");
  const std::string run = "run " + path("scenarios/small.toml") + " --quiet --out ";
  ASSERT_EQ(run_program(run + path("whole")).exit_code, 0);
  fs::copy(file("whole"), file("killed"), fs::copy_options::recursive);
  fs::rename(file("killed/sequence"), file("killed/.sequence.partial-edvo"));
  write("killed/.sequence.old-edvo/.edvo-files", "");
  fs::remove(file("killed/report.json"));
  const ProgramResult result = run_program(run + path("killed") + " --force");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(support::contents(file("whole")), support::contents(file("killed")));
}

TEST_F(RunProgram, ForceLeavesNothingThatAnotherRunMade) {
  write_scenario("small", "0.01");
  write_scenario("lost", "0.01\n[odometry]\ntracker.align.min_points = 1000000");
  const auto run = [&](const std::string& name, const std::string& rest) {
    return run_program("run " + path("scenarios/" + name + ".toml") + " --quiet --force --out " +
                       path("out") + rest);
  };
  ASSERT_EQ(run("small", "").exit_code, 0);
  ASSERT_TRUE(exists("out/trajectory.svg") && exists("out/panels"));
  EXPECT_EQ(run("small", " --debug-images 0").exit_code, 0);
  EXPECT_FALSE(exists("out/panels"));
  EXPECT_NE(run("lost", "").exit_code, 0);
  EXPECT_FALSE(exists("out/trajectory.svg"));
}

TEST_F(RunProgram, NamesFileAndLineOfAnUnknownKey) {
  write_scenario("small", "0.01\nkeyfarmes.min = 1");
  const ProgramResult result =
      run_program("run " + path("scenarios/small.toml") + " --out " + path("r"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("small.toml:19: unknown key"));
  EXPECT_FALSE(exists("r"));
}

TEST_F(RenderProgram, NotesWhatItsModeLeavesOutOfMaterialsAndRefusesItIfStrict) {
  synth::GltfDocument document = synth::triangle_document();
  document.json["extensionsUsed"] = {"KHR_materials_transmission"};
  document.json["materials"] = {
      {{"name", "pane"},
       {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}}};
  document.primitive()["material"] = 0;
  const support::TempFolder folder;
  const std::string render =
      "render '" + document.write(folder).string() +
      "' --path orbit --orbit.centre=0.3,0.3,0 --orbit.radius 2 --orbit.height 0.5 --rate 4 "
      "--duration 0.3 --size 32x24 --samples 1 --out ";
  const char* note = "transmission is drawn opaque";
  const ProgramResult direct = run_program(render + path("direct"));
  EXPECT_EQ(direct.exit_code, 0) << direct.err;
  EXPECT_THAT(direct.err, HasSubstr(note));
  EXPECT_THAT(direct.err, HasSubstr("\"pane\""));
  const ProgramResult strict = run_program(render + path("strict") + " --strict");
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_THAT(strict.err, HasSubstr(note));
  EXPECT_FALSE(exists("strict"));
  const ProgramResult traced = run_program(render + path("traced") + " --mode path --strict");
  EXPECT_EQ(traced.exit_code, 0) << traced.err;
  EXPECT_THAT(traced.err, testing::Not(HasSubstr(note)));
}

/// Adds lamps to a document, one at each of as many nodes.
void add_lamps(synth::GltfDocument& document, int count) {
  document.json["extensionsUsed"] = {"KHR_lights_punctual"};
  document.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  for (int i = 0; i < count; ++i) {
    document.json["scenes"][0]["nodes"].push_back(document.json["nodes"].size());
    document.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  }
}

TEST_F(RenderProgram, RefusesWhatTheRasterizerCannotDrawBeforeAnythingIsWritten) {
  const support::TempFolder plain_folder;
  const std::string plain = synth::triangle_document().write(plain_folder).string();
  synth::GltfDocument lit = synth::triangle_document();
  add_lamps(lit, 65);
  const support::TempFolder lit_folder;
  const std::string lamps = lit.write(lit_folder).string();
  const std::string image = "width = 32\nheight = 24\nfx = 30.0\nfy = 30.0\ncx = 15.5\ncy = 11.5\n";
  const std::string lens = image + "distortion.k1 = 0.1\n";
  write("lens.toml", lens);
  write("rig.toml", "[[camera]]\nname = \"a\"\n" + image);
  write("lens_rig.toml",
        "[[camera]]\nname = \"a\"\n" + image + "[[camera]]\nname = \"b\"\n" + lens);
  write("shutter_rig.toml",
        "[[camera]]\nname = \"a\"\n" + image + "sensor.shutter.readout_time = 0.01\n");
  struct Case {
    std::string scene, options;
    int exit_code;
    std::string message;
  };
  for (const Case& refused :
       {Case{plain, "--sensor kinect-v1", 2, "rasterizer: cannot draw motion blur"},
        Case{plain, "--camera " + path("lens.toml"), 2, "rasterizer: cannot draw through a lens"},
        Case{plain, "--environment sky:40", 3, "rasterizer: cannot draw an environment"},
        Case{lamps, "", 3, "rasterizer: the scene has 65 lights"},
        Case{plain, "--rig " + path("lens_rig.toml"), 3, "camera 'b': rasterizer: cannot draw"},
        Case{plain, "--rig " + path("shutter_rig.toml"), 3, "camera 'a': rasterizer: cannot draw"},
        Case{plain, "--environment sky:40 --rig " + path("rig.toml"), 3, "an environment"}}) {
    const ProgramResult result =
        run_program("render '" + refused.scene + "' --renderer rasterizer --path still --rate 10 " +
                    "--duration 0.1 --samples 1 " + refused.options + " --out " + path("out"));
    EXPECT_EQ(result.exit_code, refused.exit_code) << refused.options << result.err;
    EXPECT_THAT(result.err, HasSubstr(refused.message)) << refused.options;
    EXPECT_FALSE(exists("out") || exists("out.part")) << refused.options;
  }
}

}  // namespace
