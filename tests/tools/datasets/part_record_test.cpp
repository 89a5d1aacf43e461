#include "tools/datasets/part_record.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "vo/core/error.h"

namespace {

tools::PartRecord record_with(const std::string& name) {
  return {.part = "room_walk_plain_0-000",
          .plan = std::string(32, 'a'),
          .host = "host",
          .processor_s = 0.1,
          .files = {{name, 3, std::string(64, '0')}},
          .index_files = {{"frames.rows", 5, std::string(64, '1')}}};
}

std::string error_of_reading(const std::string& text) {
  const support::TempFolder folder;
  folder.write("part.json", text);
  try {
    tools::read_part_record(folder.path());
  } catch (const vo::Error& error) {
    return error.what();
  }
  return "";
}

TEST(PartRecord, IsReadAsItWasWritten) {
  const support::TempFolder folder;
  const tools::PartRecord written = record_with("room_walk_plain_0/rgb/000000.png");
  folder.write("part.json", tools::format_part_record(written));
  const tools::PartRecord read = tools::read_part_record(folder.path());
  EXPECT_EQ(tools::format_part_record(read), tools::format_part_record(written));
  EXPECT_EQ(read.files.at(0).name, "room_walk_plain_0/rgb/000000.png");
}

/// A record that edvo would write, but for a name, is refused where the name is none in its folder.
TEST(PartRecord, NamesFilesInItsFolderAlone) {
  for (const std::string name :
       {"", ".", "..", "/", "/home", "../rgb.txt", "rgb/../rgb.txt", "./rgb.txt", "rgb/"}) {
    const std::string error = error_of_reading(tools::format_part_record(record_with(name)));
    EXPECT_NE(error.find("part.json: files: '" + name + "'"), std::string::npos) << error;
  }
  EXPECT_EQ(error_of_reading(tools::format_part_record(record_with("rgb/0..png"))), "");
}

/// One digit that is another, a member that is gone, and a record of an earlier edvo, without hash.
TEST(PartRecord, IsRefusedWhereItWasEdited) {
  const std::string text = tools::format_part_record(record_with("rgb.txt"));
  EXPECT_EQ(error_of_reading(text), "");
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"bytes\":3", "\"bytes\":4"}, {"\"host\":\"host\",", ""}, {"\"hash\"", "\"other\""}}) {
    std::string edited = text;
    edited.replace(edited.find(from), from.size(), to);
    const std::string error = error_of_reading(edited);
    EXPECT_NE(error.find("part.json: is not as it was written: its hash differs"),
              std::string::npos)
        << edited << error;
  }
}

TEST(PartRecord, IsOfItsSchema) {
  const std::string text = tools::format_part_record(record_with("rgb.txt"));
  for (const auto& [from, to, problem] : std::vector<std::array<std::string, 3>>{
           {"edvo.dataset_part", "edvo.dataset_plan",
            "is no JSON document of schema edvo.dataset_part"},
           {"\"schema_version\":1", "\"schema_version\":9", "schema_version: got 9, expected 1"},
           {"}", "", "is no JSON document of schema edvo.dataset_part"}}) {
    std::string other = text;
    other.replace(other.rfind(from), from.size(), to);
    const std::string error = error_of_reading(other);
    EXPECT_NE(error.find("part.json: " + problem), std::string::npos) << error;
  }
}

}  // namespace
