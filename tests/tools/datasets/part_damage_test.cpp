#include "tools/datasets/merging/part_damage.h"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tools/datasets/part_record.h"
#include "tools/datasets/sha256.h"

namespace {

const std::string kPlanHash(32, 'a');

/// The first two of three frames of `room_walk_plain_0` as a part's folder, whose record has the
/// hash of what it says, be that true or not.
struct SmallPart {
  std::string rows =
      "train,room_walk_plain_0,0,0,,train/room/room_walk_plain_0/rgb/000000.png,"
      "train/room/room_walk_plain_0/depth/000000.png,0,0,0,0,0,0,1,1,0,1,1,1\n"
      "train,room_walk_plain_0,1,0.1,,train/room/room_walk_plain_0/rgb/000001.png,"
      "train/room/room_walk_plain_0/depth/000001.png,0,0,0,0,0,0,1,1,0,1,1,1\n";
  std::string part = "room_walk_plain_0-000";
  std::string plan = kPlanHash;
  std::vector<std::string> files = {
      "room_walk_plain_0/rgb/000000.png", "room_walk_plain_0/depth/000000.png",
      "room_walk_plain_0/rgb/000001.png", "room_walk_plain_0/depth/000001.png"};
  std::vector<std::string> index_files = {"frames.rows", "picture.webp"};
};

/// Writes a part as `change` makes it, and returns what is found wrong with it.
std::string damage_after(const std::function<void(SmallPart&)>& change) {
  SmallPart small;
  change(small);
  const support::TempFolder folder;
  tools::PartRecord record{.part = small.part, .plan = small.plan, .host = "host"};
  for (const std::string& file : small.files) {
    folder.write(file, file);
    record.files.push_back({file, file.size(), tools::sha256(file)});
  }
  for (const std::string& file : small.index_files) {
    folder.write(file, small.rows);
    record.index_files.push_back({file, small.rows.size(), tools::sha256(small.rows)});
  }
  folder.write("part.json", tools::format_part_record(record));
  tools::DatasetSpec spec;
  tools::DatasetSequence& sequence = spec.sequences.emplace_back();
  sequence.name = "room_walk_plain_0";
  sequence.scene = "room";
  sequence.split = "train";
  const tools::DatasetPlan plan{.frames = {3}, .parts = {{0, 0, 0, 2}, {0, 1, 2, 3}}};
  return tools::damage_of_part({spec, plan, kPlanHash, 0}, folder.path(), folder.path() / "none");
}

TEST(PartDamage, IsNoneOfAPartAsThePlanHasIt) {
  EXPECT_EQ(damage_after([](SmallPart& /*part*/) {}), "");
}

/// A record that says of itself what is not so is found by what the plan says.
TEST(PartDamage, IsWhatThePlanSaysOtherwise) {
  const auto expect = [](const std::string& damage, const std::function<void(SmallPart&)>& change) {
    EXPECT_NE(damage_after(change).find(damage), std::string::npos) << damage_after(change);
  };
  expect("is of part room_walk_plain_0-001, expected room_walk_plain_0-000",
         [](SmallPart& part) { part.part = "room_walk_plain_0-001"; });
  expect("is of another data set", [](SmallPart& part) { part.plan = std::string(32, 'b'); });
  expect("index_files: expected frames.rows", [](SmallPart& part) { part.index_files.pop_back(); });
  expect("expected train/room/room_walk_plain_0/rgb/000000.png",
         [](SmallPart& part) { part.files.clear(); });
  expect("expected train/room/room_walk_plain_0/depth/000001.png",
         [](SmallPart& part) { part.files.pop_back(); });
  expect("room_walk_plain_1/rgb.txt is no file of room_walk_plain_0",
         [](SmallPart& part) { part.files.emplace_back("room_walk_plain_1/rgb.txt"); });
}

TEST(PartDamage, IsARowThatThePlanDoesNotHave) {
  const auto expect = [](const std::string& damage,
                         const std::function<void(std::string&)>& change) {
    const std::string found = damage_after([&](SmallPart& part) { change(part.rows); });
    EXPECT_NE(found.find(damage), std::string::npos) << found;
  };
  expect("frames.rows: 0 rows, expected 2", [](std::string& rows) { rows.clear(); });
  expect("frames.rows: 1 rows, expected 2",
         [](std::string& rows) { rows.resize(rows.find('\n') + 1); });
  expect("frames.rows:1: expected frame 0 of room_walk_plain_0",
         [](std::string& rows) { rows.erase(0, rows.find('\n') + 1); });
  expect("frames.rows:3: expected frame 2 of room_walk_plain_0",
         [](std::string& rows) { rows += rows; });
  expect("columns, expected 19", [](std::string& rows) { rows = "train,room_walk_plain_0\n"; });
}

}  // namespace
