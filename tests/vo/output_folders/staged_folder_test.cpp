#include "vo/output_folders/staged_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/error_text.h"
#include "tests/support/folder_contents.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/output_folders/file_records.h"

namespace {

namespace fs = std::filesystem;

using support::contents;
using support::error_kind;
using support::error_text;
using support::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using vo::ErrorKind;
using vo::ExistingOutput;
using vo::StagedFolder;

/// Two parts of two files each, and a list.
vo::StagedContent example(const std::string& marker = "1") {
  return {{"marker", marker},
          {{"0", {"a/0", "b/0"}}, {"1", {"a/1", "b/1"}}},
          {{"list.txt", "0 and 1"}}};
}

void put(const StagedFolder& staged, const vo::FolderPart& part) {
  auto claim = staged.claim(part);
  ASSERT_TRUE(claim.has_value()) << part.name;
  staged.put(std::move(*claim),
             {{part.files[0], "A" + part.name}, {part.files[1], "B" + part.name}});
}

class StagedFolderTest : public testing::Test {
 protected:
  StagedFolder join(ExistingOutput existing = ExistingOutput::keep) const {
    return StagedFolder(path_, content_, existing, {});
  }

  std::size_t entries_beside() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  const TempFolder folder_;
  const fs::path path_ = folder_.path() / "result";
  const vo::StagedContent content_ = example();
};

TEST_F(StagedFolderTest, IsFilledByRunsOneAfterTheOther) {
  { put(join(), content_.parts[0]); }
  EXPECT_FALSE(fs::exists(path_));
  folder_.write("result.part/a/.1.partial-edvo", "of a run that was killed");
  folder_.write(".result.lock-edvo", "");
  {
    StagedFolder second = join();
    EXPECT_TRUE(second.has(content_.parts[0]));
    EXPECT_FALSE(second.has(content_.parts[1]));
    EXPECT_FALSE(second.claim(content_.parts[0]).has_value());
    put(second, content_.parts[1]);
    EXPECT_THAT(second.finish(), IsEmpty());
    EXPECT_TRUE(second.is_finished());
  }
  auto files = contents(path_);
  files.erase(vo::kFileList);
  EXPECT_EQ(files, (std::map<std::string, std::string>{{"a/0", "A0"},
                                                       {"a/1", "A1"},
                                                       {"b/0", "B0"},
                                                       {"b/1", "B1"},
                                                       {"list.txt", "0 and 1"},
                                                       {"marker", "1"}}));
  EXPECT_EQ(entries_beside(), 1U);
  EXPECT_TRUE(join().is_finished());
  EXPECT_EQ(entries_beside(), 1U);
}

TEST_F(StagedFolderTest, GivesAPartToOneOfSeveralRunsAtATime) {
  StagedFolder first = join();
  const StagedFolder second = join();
  auto claim = first.claim(content_.parts[0]);
  ASSERT_TRUE(claim.has_value());
  EXPECT_FALSE(second.claim(content_.parts[0]).has_value());
  claim.reset();
  put(second, content_.parts[0]);
  EXPECT_FALSE(first.claim(content_.parts[0]).has_value()) << "it is there";
  put(first, content_.parts[1]);
  EXPECT_TRUE(second.has(content_.parts[1]));
}

TEST_F(StagedFolderTest, MakesDamagedFilesAgain) {
  StagedFolder staged = join();
  put(staged, content_.parts[0]);
  put(staged, content_.parts[1]);
  folder_.write("result.part/b/1", "B2");  // as long, but other bytes
  ASSERT_TRUE(staged.has(content_.parts[1]));
  EXPECT_THAT(staged.finish(), ElementsAre(1));
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_FALSE(staged.has(content_.parts[1]));
  put(staged, content_.parts[1]);
  fs::resize_file(staged.staging() / "a/0", 0);
  EXPECT_FALSE(staged.has(content_.parts[0])) << "it is too short";
  put(staged, content_.parts[0]);
  EXPECT_THAT(staged.finish(), IsEmpty());
  EXPECT_EQ(vo::read_file(path_ / "b/1"), "B1");
  EXPECT_EQ(vo::read_file(path_ / "a/0"), "A0");
}

TEST_F(StagedFolderTest, GoesOnWhereARunWasKilledWhileItFinished) {
  {
    StagedFolder staged = join();
    put(staged, content_.parts[0]);
    put(staged, content_.parts[1]);
    EXPECT_THAT(staged.finish(), IsEmpty());
  }
  fs::rename(path_, vo::partial_name(path_));
  folder_.write(".result.partial-edvo/edvo-done/1.txt", "");
  folder_.write(".result.old-edvo/mine", "what was about to be replaced");
  EXPECT_EQ(error_kind([&] { join(); }), ErrorKind::output_exists);
  EXPECT_EQ(vo::read_file(path_ / "mine"), "what was about to be replaced");
  fs::remove_all(path_);
  {
    StagedFolder staged = join();
    EXPECT_TRUE(staged.has(content_.parts[0]) && staged.has(content_.parts[1]));
    EXPECT_THAT(staged.finish(), IsEmpty());
  }
  EXPECT_EQ(vo::read_file(path_ / "list.txt"), "0 and 1");
  EXPECT_FALSE(fs::exists(path_ / "edvo-done"));
  EXPECT_EQ(entries_beside(), 1U);
}

TEST_F(StagedFolderTest, MakesAFinishedFolderAgainWhereItsBytesAreOthers) {
  const auto make = [&](ExistingOutput existing) {
    StagedFolder staged = join(existing);
    if (!staged.is_finished()) {
      put(staged, content_.parts[0]);
      put(staged, content_.parts[1]);
      EXPECT_THAT(staged.finish(), IsEmpty());
      EXPECT_TRUE(staged.is_finished());
    }
  };
  make(ExistingOutput::keep);
  const auto whole = contents(path_);
  folder_.write("result/b/1", "B2");  // as long
  EXPECT_THAT(error_text([&] { make(ExistingOutput::keep); }),
              HasSubstr("result/b/1: has other bytes than were written; --force makes result"));
  make(ExistingOutput::replace);
  EXPECT_EQ(contents(path_), whole);
  EXPECT_EQ(entries_beside(), 1U);
}

TEST_F(StagedFolderTest, WaitsForNoPipeThatSomebodyPutIntoIt) {
  {
    StagedFolder staged = join();
    put(staged, content_.parts[0]);
    put(staged, content_.parts[1]);
    ASSERT_EQ(::mkfifo((staged.staging() / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(staged.finish(), IsEmpty());
  }
  EXPECT_TRUE(join().is_finished());
}

TEST_F(StagedFolderTest, LeavesAFinishedFolderOfItsUnfinishedNameAlone) {
  const fs::path finished = StagedFolder::staging_of(path_);
  {
    StagedFolder staged(finished, content_, ExistingOutput::keep, {});
    put(staged, content_.parts[0]);
    put(staged, content_.parts[1]);
    EXPECT_THAT(staged.finish(), IsEmpty());
  }
  const auto before = contents(finished);
  for (const ExistingOutput existing : {ExistingOutput::keep, ExistingOutput::replace}) {
    EXPECT_EQ(error_kind([&] { join(existing); }), ErrorKind::input);
    EXPECT_THAT(error_text([&] { join(existing); }),
                HasSubstr("result.part: is no unfinished result of result"));
  }
  EXPECT_EQ(contents(finished), before);
  EXPECT_EQ(entries_beside(), 1U);
}

TEST_F(StagedFolderTest, IsBegunAnewForAnotherResultOnlyWhenToldToReplaceIt) {
  { put(join(), content_.parts[0]); }
  const vo::StagedContent other = example("2");
  const auto begin = [&](ExistingOutput existing) { StagedFolder(path_, other, existing, {}); };
  EXPECT_EQ(error_kind([&] { begin(ExistingOutput::keep); }), ErrorKind::output_exists);
  EXPECT_TRUE(join(ExistingOutput::replace).has(content_.parts[0])) << "the same result";
  {
    const StagedFolder busy = join();
    EXPECT_EQ(error_kind([&] { begin(ExistingOutput::replace); }), ErrorKind::temporary);
  }
  begin(ExistingOutput::replace);
  EXPECT_FALSE(fs::exists(StagedFolder::staging_of(path_) / "a/0"));
}

TEST_F(StagedFolderTest, NeverRemovesAFileThatItDidNotWrite) {
  { put(join(), content_.parts[0]); }
  folder_.write("result.part/a/mine", "precious");
  const vo::StagedContent other = example("2");
  const auto begin = [&] { StagedFolder(path_, other, ExistingOutput::replace, {}); };
  EXPECT_EQ(error_kind(begin), ErrorKind::input);
  EXPECT_THAT(error_text(begin), HasSubstr("holds a/mine, which edvo did not write"));
  EXPECT_EQ(vo::read_file(StagedFolder::staging_of(path_) / "a/mine"), "precious");
}

TEST_F(StagedFolderTest, NeverReplacesWhatSomebodyElseMade) {
  folder_.write("result.part/holiday", "precious");
  EXPECT_EQ(error_kind([&] { join(ExistingOutput::replace); }), ErrorKind::input);
  EXPECT_EQ(vo::read_file(folder_.path() / "result.part/holiday"), "precious");
}

TEST_F(StagedFolderTest, ListsTheFilesOfAFolderWithinAsIfThatStoodAlone) {
  vo::StagedContent content = example();
  content.rest.push_back({"a/more.txt", "more"});
  content.folders = {"a"};
  StagedFolder staged(path_, content, ExistingOutput::keep, {});
  put(staged, content.parts[0]);
  put(staged, content.parts[1]);
  EXPECT_THAT(staged.finish(), IsEmpty());
  const vo::FileRecords records = vo::read_list(path_ / "a");
  ASSERT_EQ(records.size(), 3U);
  for (const auto& [name, record] : records) {
    EXPECT_TRUE(vo::is_intact(path_ / "a", name, record)) << name;
  }
  EXPECT_TRUE(StagedFolder(path_, content, ExistingOutput::keep, {}).is_finished());
  vo::require_replaceable(path_, ExistingOutput::replace);
}

}  // namespace
