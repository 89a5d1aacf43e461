#include "tools/processes/scratch_folder.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
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

/// The lock file of a folder.
fs::path lock_of(const fs::path& folder) {
  return folder.string() + ".lock";
}

TEST(ScratchFolder, OfAKilledProcessIsRemovedByTheNext) {
  const tools::ScratchFolder in_use;
  const fs::path abandoned = in_use.path().parent_path() / "edvo-testAB";
  vo::write_files(abandoned, {{"a/file", "bytes"}});
  vo::write_file(lock_of(abandoned), "");
  const fs::path somebodys = in_use.path().parent_path() / "edvo-testCD";  // without a lock file
  fs::create_directories(somebodys);
  const tools::ScratchFolder next;
  EXPECT_FALSE(fs::exists(abandoned));
  EXPECT_FALSE(fs::exists(lock_of(abandoned)));
  EXPECT_TRUE(fs::exists(in_use.path()));
  EXPECT_TRUE(fs::exists(somebodys));
  fs::remove(somebodys);
}

/// Sets TMPDIR until it is destroyed.
class TemporaryPlace {
 public:
  explicit TemporaryPlace(const char* value) {
    // NOLINTBEGIN(concurrency-mt-unsafe): the tests have one thread
    if (const char* before = std::getenv("TMPDIR")) {
      before_ = before;
    }
    ::setenv("TMPDIR", value, 1);
  }
  ~TemporaryPlace() {
    before_ ? ::setenv("TMPDIR", before_->c_str(), 1) : ::unsetenv("TMPDIR");
    // NOLINTEND(concurrency-mt-unsafe)
  }
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;
  TemporaryPlace(TemporaryPlace&&) = delete;
  TemporaryPlace& operator=(TemporaryPlace&&) = delete;

 private:
  std::optional<std::string> before_;
};

TEST(ScratchFolder, NamesTheVariableWhosePlaceIsNoFolderAndTakesTmpForAnEmptyOne) {
  const auto make = [] { const tools::ScratchFolder folder; };
  {
    const TemporaryPlace none("/none");
    EXPECT_THAT(support::error_text(make), testing::HasSubstr("TMPDIR: /none is no folder"));
  }
  const TemporaryPlace empty("");
  EXPECT_EQ(tools::ScratchFolder().path().parent_path(), "/tmp");
}

}  // namespace
