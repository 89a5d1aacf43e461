#include "vo/files/result_files.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"

namespace {

namespace fs = std::filesystem;

using support::TempFolder;

TEST(FolderForResults, RemovesWhatItMadeAndNobodyUsed) {
  const TempFolder folder;
  fs::create_directory(folder.path() / "there");
  {
    const vo::FolderForResults results(folder.path() / "there/a/b/");
    EXPECT_TRUE(fs::is_directory(folder.path() / "there/a/b"));
  }
  EXPECT_FALSE(fs::exists(folder.path() / "there/a"));
  EXPECT_TRUE(fs::is_directory(folder.path() / "there"));
  { const vo::FolderForResults results(folder.path() / "there"); }
  EXPECT_TRUE(fs::is_directory(folder.path() / "there")) << "it was there before";
}

TEST(FolderForResults, KeepsWhatHoldsSomething) {
  const TempFolder folder;
  {
    const vo::FolderForResults results(folder.path() / "a/b");
    vo::write_results(folder.path() / "a/b", {{"table.csv", "1\n"}}, vo::ExistingOutput::keep);
  }
  EXPECT_EQ(vo::read_file(folder.path() / "a/b/table.csv"), "1\n");
}

TEST(FolderForResults, IsAnErrorWhereNoFolderCanBe) {
  const TempFolder folder;
  const fs::path file = folder.write("file", "");
  EXPECT_NE(support::error_text([&] { const vo::FolderForResults results(file / "a"); }), "");
  EXPECT_TRUE(fs::is_regular_file(file));
}

}  // namespace
