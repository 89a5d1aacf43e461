#include "tools/datasets/part_record.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "vo/core/error.h"

namespace {

tools::PartRecord record_with(const std::string& name) {
  return {.part = "room_walk_plain_0-000",
          .host = "host",
          .processor_s = 0.1,
          .files = {{name, 3, std::string(64, '0')}}};
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

}  // namespace
