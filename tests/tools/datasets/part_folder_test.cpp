#include "tools/datasets/part_folder.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"

namespace {

/// Makes a part whose record is `record`, and returns all that lies beside it then.
std::size_t entries_after_part(const std::filesystem::path& path, const std::string& record) {
  tools::PartFolder folder(path);
  folder.write({{"part.json", record}});
  folder.commit(vo::Durability::unsynced);
  return vo::entries_of(path.parent_path()).size();
}

TEST(PartFolder, KeepsThePartThatWasThereFirst) {
  const support::TempFolder folder;
  entries_after_part(folder.path() / "part", "first");
  EXPECT_EQ(entries_after_part(folder.path() / "part", "second"), 2U);  // the own partial one, too
  EXPECT_EQ(vo::read_file(folder.path() / "part/part.json"), "first");
  EXPECT_EQ(vo::entries_of(folder.path()).size(), 1U);
}

TEST(PartFolder, ReplacesAFolderWithoutRecord) {
  const support::TempFolder folder;
  folder.write("part/rgb/000000.png", "of a copy that was broken off");
  EXPECT_EQ(entries_after_part(folder.path() / "part", "whole"), 1U);
  EXPECT_EQ(vo::read_file(folder.path() / "part/part.json"), "whole");
  EXPECT_EQ(vo::entries_below(folder.path() / "part").size(), 1U);
}

}  // namespace
