#include "vo/files/output.h"

#include <memory>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/output_folders/output_folder.h"

namespace {

namespace fs = std::filesystem;

using support::error_kind;
using support::error_text;
using support::TempFolder;
using testing::HasSubstr;
using vo::ErrorKind;
using vo::ExistingOutput;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void fill(const fs::path& path, const std::string& content, ExistingOutput existing) {
  vo::OutputFolder output(path, existing, {});
  output.write({{"marker", content}});
  output.commit();
}

TEST(WriteFile, ReadsBackAndLeavesNothingElse) {
  const TempFolder folder;
  vo::write_file(folder.path() / "a", std::string("x\0y", 3));
  EXPECT_EQ(vo::read_file(folder.path() / "a"), std::string("x\0y", 3));
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(WriteFile, KeepsAFileThatDiffersUnlessToldToReplaceIt) {
  const TempFolder folder;
  const fs::path path = folder.path() / "a";
  vo::write_file(path, "old");
  EXPECT_NO_THROW(vo::write_file(path, "old"));
  EXPECT_EQ(error_kind([&] { vo::write_file(path, "new"); }), ErrorKind::output_exists);
  EXPECT_EQ(vo::read_file(path), "old");
  vo::write_file(path, "new", ExistingOutput::replace);
  EXPECT_EQ(vo::read_file(path), "new");
}

TEST(WriteFile, AFullDiskIsTemporary) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "there is no /dev/full";
  }
  const auto write = [] { vo::write_file("/dev/full", "x"); };
  EXPECT_EQ(error_kind(write), ErrorKind::temporary);
  EXPECT_THAT(error_text(write), HasSubstr("/dev/full: cannot be written: No space left"));
}

TEST(WriteFile, AFileInMemoryIsAFile) {
  if (!fs::is_directory("/dev/shm")) {
    GTEST_SKIP() << "there is no /dev/shm";
  }
  std::string name = "/dev/shm/edvo-test-XXXXXX";
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const auto remove = [](const fs::path* folder) { fs::remove_all(*folder); };
  const fs::path folder = name;
  const std::unique_ptr<const fs::path, decltype(remove)> removing(&folder, remove);
  vo::write_file(folder / "a", "old");
  EXPECT_EQ(error_kind([&] { vo::write_file(folder / "a", "new"); }), ErrorKind::output_exists);
  EXPECT_EQ(vo::read_file(folder / "a"), "old");
}

TEST(IsStream, DevicesPipesAndDescriptorsAre) {
  for (const char* path : {"/dev/null", "/dev/stdout", "/dev/stderr", "/dev/fd/1",
                           "/dev/../dev/full", "/proc/self/fd/1"}) {
    EXPECT_TRUE(vo::is_stream(path)) << path;
  }
  for (const char* path : {"/dev/none", "/dev/shm", "/dev", "/none"}) {
    EXPECT_FALSE(vo::is_stream(path)) << path;
  }
}

TEST(WriteFile, APlaceThatIsNotThereIsNamed) {
  const TempFolder folder;
  const fs::path path = folder.path() / "none" / "a";
  EXPECT_THAT(error_text([&] { vo::write_file(path, "x"); }), HasSubstr("cannot be written"));
  EXPECT_THAT(error_text([&] { vo::require_writable(path); }), HasSubstr("there is no folder"));
  EXPECT_THAT(error_text([&] { vo::require_writable(folder.path()); }), HasSubstr("is a folder"));
}

TEST(WriteFile, WritesTheTargetOfALink) {
  const TempFolder folder;
  vo::write_file(folder.path() / "real", "old");
  fs::create_symlink("real", folder.path() / "link");
  vo::write_file(folder.path() / "link", "new", ExistingOutput::replace);
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(vo::read_file(folder.path() / "real"), "new");
}

TEST(WriteFile, WritesTheTargetOfALinkThatIsNotThereYet) {
  const TempFolder folder;
  fs::create_symlink("real", folder.path() / "inner");
  fs::create_symlink("inner", folder.path() / "link");
  EXPECT_EQ(vo::resolved_output(folder.path() / "link"),
            vo::resolved_output(folder.path() / "real"));
  vo::write_file(folder.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(vo::read_file(folder.path() / "real"), "new");
  fs::create_symlink("b", folder.path() / "a");
  fs::create_symlink("a", folder.path() / "b");
  EXPECT_THAT(error_text([&] { vo::resolved_output(folder.path() / "a"); }),
              HasSubstr("cannot be written"));
}

TEST(WriteFile, TakesOverWhatAKilledProcessLeft) {
  const TempFolder folder;
  folder.write(".a.partial-edvo", "longer than what is written now");
  vo::write_file(folder.path() / "a", "new");
  EXPECT_EQ(vo::read_file(folder.path() / "a"), "new");
  EXPECT_EQ(entries(folder.path()), 1U);
  folder.write(".a.partial-edvo", "of a run that would have replaced it");
  vo::write_file(folder.path() / "a", "new");
  EXPECT_EQ(entries(folder.path()), 1U) << "the file is there already";
}

TEST(WriteFile, RemovesTheFolderThatAKilledProcessLeftUnderItsPartialName) {
  const TempFolder folder;
  for (const char* content : {"new", "new"}) {  // the second finds the file there already
    folder.write(".a.partial-edvo/half", "of a folder whose writer was killed");
    vo::write_file(folder.path() / "a", content);
    EXPECT_EQ(vo::read_file(folder.path() / "a"), content);
    EXPECT_EQ(entries(folder.path()), 1U);
  }
}

TEST(WriteFile, LeavesAFolderToTheProcessThatMakesIt) {
  const TempFolder folder;
  const fs::path path = folder.path() / "a";
  vo::OutputFolder living(path, ExistingOutput::keep, {});
  living.write({{"marker", "1"}});
  EXPECT_FALSE(vo::PartialFile::try_open(path).has_value());
  living.commit();
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
}

TEST(WriteFile, IsDoneByOneProcessAtATime) {
  const TempFolder folder;
  const fs::path path = folder.path() / "a";
  std::optional<vo::PartialFile> first = vo::PartialFile::try_open(path);
  ASSERT_TRUE(first.has_value());
  EXPECT_FALSE(vo::PartialFile::try_open(path).has_value());
  first->commit("1", vo::Durability::unsynced);
  std::optional<vo::PartialFile> second = vo::PartialFile::try_open(path);
  ASSERT_TRUE(second.has_value()) << "the first has committed";
  first.reset();
  EXPECT_FALSE(vo::PartialFile::try_open(path).has_value()) << "the second still writes";
  second->commit("2", vo::Durability::synced);
  EXPECT_EQ(vo::read_file(path), "2");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(OutputFolder, TouchesNoFileThatIsNotItsOwn) {
  const TempFolder folder;
  folder.write("result.partial/thesis", "precious");
  folder.write("result.old/thesis", "precious");
  for (const char* content : {"1", "2"}) {
    fill(folder.path() / "result/.", content, ExistingOutput::replace);
    EXPECT_EQ(vo::read_file(folder.path() / "result/marker"), content);
  }
  EXPECT_EQ(vo::read_file(folder.path() / "result.partial/thesis"), "precious");
  EXPECT_EQ(vo::read_file(folder.path() / "result.old/thesis"), "precious");
  EXPECT_EQ(entries(folder.path()), 3U);
}

TEST(OutputFolder, WillNotReplaceTheCurrentFolder) {
  const fs::path here = fs::current_path();
  EXPECT_EQ(error_kind([&] { fill(here, "1", ExistingOutput::replace); }), ErrorKind::input);
  EXPECT_EQ(error_kind([&] { fill(here / "..", "1", ExistingOutput::replace); }), ErrorKind::input);
  EXPECT_TRUE(fs::exists(here));
}

TEST(OutputFolder, AppearsOnlyWhenCommitted) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  {
    vo::OutputFolder output(path, ExistingOutput::keep, {});
    output.write({{"marker", "1"}});
  }
  EXPECT_EQ(entries(folder.path()), 0U) << "abandoned without a trace";
  {
    vo::OutputFolder output(path, ExistingOutput::keep, {});
    output.write({{"marker", "1"}});
    output.commit();
  }
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
  EXPECT_EQ(entries(folder.path()), 1U);
}

/// Acts as a user who is bound by permissions while it lives; does nothing for who is one already.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (::geteuid() == 0) {
      EXPECT_EQ(::seteuid(kNobody), 0);
    }
  }
  ~OrdinaryUser() { EXPECT_EQ(::seteuid(::getuid()), 0); }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  OrdinaryUser(OrdinaryUser&&) = delete;
  OrdinaryUser& operator=(OrdinaryUser&&) = delete;

  /// Gives a file or folder to this user, if it is another.
  static void own(const fs::path& path) {
    if (::geteuid() == 0) {
      EXPECT_EQ(::chown(path.c_str(), kNobody, kNobody), 0);
    }
  }

 private:
  static constexpr uid_t kNobody = 65534;
};

void fill_deep(const fs::path& path, const std::string& content) {
  vo::OutputFolder output(path, ExistingOutput::replace, {});
  output.write({{"marker", content}, {"sub/file", content}});
  output.commit();
}

TEST(OutputFolder, ReplacesAFolderOfOnesOwnThatIsReadOnly) {
  const TempFolder folder;
  OrdinaryUser::own(folder.path());
  const OrdinaryUser user;
  const fs::path path = folder.path() / "result";
  for (const char* content : {"1", "2", "3"}) {
    fill_deep(path, content);
    EXPECT_EQ(vo::read_file(path / "marker"), content);
    EXPECT_EQ(entries(folder.path()), 1U) << "nothing is left of what was replaced";
    fs::permissions(path / "sub", fs::perms::owner_read | fs::perms::owner_exec);
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_exec);
  }
  vo::allow_removal(path);
}

TEST(OutputFolder, LeavesWhatSomebodyElseMustRemoveInItsPlace) {
  if (::geteuid() != 0) {
    GTEST_SKIP() << "a folder of another user needs root";
  }
  const TempFolder folder;
  OrdinaryUser::own(folder.path());
  const fs::path path = folder.path() / "result";
  fill_deep(path, "1");
  {
    const OrdinaryUser user;
    EXPECT_THAT(error_text([&] { fill_deep(path, "2"); }), HasSubstr("cannot be replaced"));
    EXPECT_EQ(vo::read_file(path / "marker"), "1");
    EXPECT_EQ(entries(folder.path()), 1U);
  }
  fill_deep(path, "2");
  EXPECT_EQ(vo::read_file(path / "marker"), "2");
}

TEST(OutputFolder, KeepsWhatDiffersUnlessToldToReplaceIt) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  fill(path, "1", ExistingOutput::keep);
  EXPECT_NO_THROW(fill(path, "1", ExistingOutput::keep)) << "the same again";
  EXPECT_EQ(error_kind([&] { fill(path, "2", ExistingOutput::keep); }), ErrorKind::output_exists);
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
  fill(path, "2", ExistingOutput::replace);
  EXPECT_EQ(vo::read_file(path / "marker"), "2");
}

TEST(OutputFolder, RemovesWhatAKilledProcessLeft) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  folder.write(".result.partial-edvo/half", "of a run that was killed");
  folder.write(".result.lock-edvo", "");
  fill(path, "1", ExistingOutput::keep);
  EXPECT_EQ(entries(folder.path()), 1U);
  EXPECT_EQ(entries(path), 2U) << "the file and the list";
}

TEST(OutputFolder, GivesBackAFolderWhoseReplacementWasKilled) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  fill(path, "1", ExistingOutput::keep);
  fs::rename(path, folder.path() / ".result.old-edvo");
  { const vo::OutputFolder begun(path, ExistingOutput::keep, {}); }
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(OutputFolder, WaitsForAnotherThatMakesTheSame) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  auto first = std::make_unique<vo::OutputFolder>(path, ExistingOutput::keep, vo::WaitObserver());
  int looks = 0;
  const vo::OutputFolder second(path, ExistingOutput::keep, [&] {
    if (++looks == 2) {
      first->write({{"marker", "of the first"}});
      first->commit();
      first.reset();
    }
  });
  EXPECT_EQ(looks, 2);
  EXPECT_EQ(vo::read_file(path / "marker"), "of the first");
}

TEST(OutputFolder, NeverRemovesAFileThatItDidNotWrite) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  fill(path, "1", ExistingOutput::keep);
  folder.write("result/notes/mine.txt", "precious");
  const auto replace = [&] { fill(path, "2", ExistingOutput::replace); };
  EXPECT_EQ(error_kind(replace), ErrorKind::input);
  EXPECT_THAT(error_text(replace), HasSubstr("holds notes/mine.txt, which edvo did not write"));
  EXPECT_EQ(vo::read_file(path / "notes/mine.txt"), "precious");
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
  fs::remove_all(path / "notes");
  fill(path, "2", ExistingOutput::replace);
  EXPECT_EQ(vo::read_file(path / "marker"), "2");
}

TEST(OutputFolder, NeverReplacesWhatSomebodyElseMade) {
  const TempFolder folder;
  const fs::path path = folder.path() / "photos";
  fs::create_directories(path);
  vo::write_file(path / "holiday", "precious");
  EXPECT_EQ(error_kind([&] { fill(path, "1", ExistingOutput::replace); }), ErrorKind::input);
  EXPECT_EQ(vo::read_file(path / "holiday"), "precious");
}

}  // namespace
