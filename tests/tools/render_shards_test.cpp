#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/folder_contents.h"
#include "tests/support/program.h"
#include "tests/support/temp_folder.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::contents;
using support::ProgramResult;
using support::run_program;
using support::TempFolder;
using testing::HasSubstr;

const std::string kRender =
    std::string("render '") + EDVO_SOURCE_DIR +
    "/assets/room/room.gltf' --path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 "
    "--orbit.height 0.8 --rate 5 --duration 1 --size 32x24 --samples 1 --float-depth --quiet ";

ProgramResult render(const fs::path& out, const std::string& options) {
  return run_program(kRender + options + " --out '" + out.string() + "'");
}

TEST(RenderShards, GiveTheBytesOfOneRunInAnyOrderOnAnyNumberOfThreads) {
  const TempFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path shards = folder.path() / "shards";
  ASSERT_EQ(render(whole, "--threads 1").exit_code, 0);
  for (const char* share : {"--shard 4/4 --threads 1", "--shard 3/4", "--shard 2/4 --threads 2"}) {
    EXPECT_EQ(render(shards, share).exit_code, 0);
    EXPECT_FALSE(fs::exists(shards));
  }
  EXPECT_EQ(render(shards, "--shard 1/4").exit_code, 0);
  EXPECT_EQ(contents(whole).size(), 3 * 6 + 6U);
  EXPECT_EQ(contents(whole), contents(shards));
  EXPECT_FALSE(fs::exists(shards.string() + ".part"));
}

TEST(RenderShards, FinishedFramesAreKeptAndMissingOnesMade) {
  const TempFolder folder;
  const fs::path whole = folder.path() / "whole";
  const fs::path out = folder.path() / "out";
  const fs::path part = folder.path() / "out.part";
  ASSERT_EQ(render(whole, "").exit_code, 0);
  const ProgramResult first = render(out, "--frames 1:4 --json");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(json::parse(first.out)["missing"], 3);
  EXPECT_EQ(json::parse(first.out)["folder"], part.string());
  fs::remove(part / "depth/000002.png");
  const ProgramResult second = render(out, "--json");
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(json::parse(second.out)["rendered"], 4) << "frames 0, 2, 4 and 5";
  EXPECT_EQ(contents(whole), contents(out));
}

TEST(RenderShards, FramesOfOtherInputsAreRefusedUnlessForced) {
  const TempFolder folder;
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(render(out, "--frames 0:1").exit_code, 0);
  const ProgramResult refused = render(out, "--ambient 0.5 --frames 1:2");
  EXPECT_EQ(refused.exit_code, 6);
  EXPECT_THAT(refused.err, HasSubstr("out.part: exists and differs"));
  EXPECT_EQ(json::parse(render(out, "--ambient 0.5 --frames 1:2 --force --json").out)["missing"],
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
  const ProgramResult result = render(out, "--plan --json --shard 1/2");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::is_empty(folder.path()));
  const json plan = json::parse(result.out);
  EXPECT_EQ(plan["frames"], 3);
  EXPECT_EQ(plan["there"], 0);
  EXPECT_EQ(plan["files"], 9);
  EXPECT_GT(plan["cpu_s"], 0);
  ASSERT_EQ(render(out, "--shard 1/2").exit_code, 0);
  double bytes = 0;
  for (const auto& [name, content] : contents(folder.path() / "out.part")) {
    bytes += name == "sequence.toml" ? 0 : static_cast<double>(content.size());
  }
  EXPECT_EQ(plan["bytes"], bytes) << "all three frames were measured";
  EXPECT_EQ(json::parse(render(out, "--plan --json").out)["there"], 3);
}

TEST(RenderShards, AShareThatIsNoneIsAnErrorOfTheCommandLine) {
  const TempFolder folder;
  for (const char* share : {"--shard 0/4", "--shard 5/4", "--frames 3:2", "--frames 0:7"}) {
    EXPECT_EQ(render(folder.path() / "out", share).exit_code, 2) << share;
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
