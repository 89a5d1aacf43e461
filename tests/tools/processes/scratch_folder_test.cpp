#include "tools/processes/scratch_folder.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "vo/files/output.h"

namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, IsRemovedWithWhatIsReadOnlyButNotWithWhatItLinksTo) {
  const tools::ScratchFolder other;
  vo::write_files(other.path(), {{"kept/file", "bytes"}});
  fs::permissions(other.path() / "kept", fs::perms::owner_read | fs::perms::owner_exec);
  fs::path path;
  {
    const tools::ScratchFolder folder;
    path = folder.path();
    vo::write_files(path, {{"a/b/file", "bytes"}});
    fs::create_directory_symlink(other.path() / "kept", path / "a" / "link");
    for (const char* name : {"a/b", "a"}) {
      fs::permissions(path / name, fs::perms::owner_read | fs::perms::owner_exec);
    }
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::exists(other.path() / "kept" / "file"));
  EXPECT_EQ(fs::status(other.path() / "kept").permissions() & fs::perms::owner_write,
            fs::perms::none);
}

}  // namespace
