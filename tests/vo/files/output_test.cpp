#include "vo/files/output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

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
  vo::OutputFolder output(path, "marker", existing);
  vo::write_file(output.partial() / "marker", content);
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
    vo::OutputFolder output(path, "marker", ExistingOutput::keep);
    vo::write_file(output.partial() / "marker", "1");
  }
  EXPECT_EQ(entries(folder.path()), 0U) << "abandoned without a trace";
  {
    vo::OutputFolder output(path, "marker", ExistingOutput::keep);
    vo::write_file(output.partial() / "marker", "1");
    output.commit();
  }
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
  EXPECT_EQ(entries(folder.path()), 1U);
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

TEST(OutputFolder, NeverReplacesWhatSomebodyElseMade) {
  const TempFolder folder;
  const fs::path path = folder.path() / "photos";
  fs::create_directories(path);
  vo::write_file(path / "holiday", "precious");
  EXPECT_EQ(error_kind([&] { fill(path, "1", ExistingOutput::replace); }), ErrorKind::input);
  EXPECT_EQ(vo::read_file(path / "holiday"), "precious");
}

TEST(StagedFolder, WaitsBesideItsNameUntilItIsCommitted) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  {
    const vo::StagedFolder first(path, {"marker", "1"}, ExistingOutput::keep);
    vo::write_file(first.staging() / "a", "of the first run");
    vo::write_file(first.staging() / ".b.partial-7", "of a run that was killed");
  }
  EXPECT_FALSE(fs::exists(path));
  vo::StagedFolder second(path, {"marker", "1"}, ExistingOutput::keep);
  EXPECT_EQ(second.staging(), vo::StagedFolder::staging_of(path));
  second.commit();
  EXPECT_EQ(vo::read_file(path / "a"), "of the first run");
  EXPECT_EQ(vo::read_file(path / "marker"), "1");
  EXPECT_EQ(entries(path), 2U);
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(StagedFolder, IsBegunAnewForAnotherResultOnlyWhenToldToReplaceIt) {
  const TempFolder folder;
  const fs::path path = folder.path() / "result";
  const auto stage = [&](const char* marker, ExistingOutput existing) {
    return vo::StagedFolder(path, {"marker", marker}, existing).staging();
  };
  const fs::path staging = stage("1", ExistingOutput::keep);
  vo::write_file(staging / "a", "of 1");
  EXPECT_EQ(error_kind([&] { stage("2", ExistingOutput::keep); }), ErrorKind::output_exists);
  EXPECT_EQ(stage("1", ExistingOutput::replace), staging);
  EXPECT_TRUE(fs::exists(staging / "a")) << "the same result";
  stage("2", ExistingOutput::replace);
  EXPECT_FALSE(fs::exists(staging / "a"));
}

TEST(StagedFolder, NeverReplacesWhatSomebodyElseMade) {
  const TempFolder folder;
  const fs::path path = folder.path() / "photos";
  folder.write("photos.part/holiday", "precious");
  const auto stage = [&] { vo::StagedFolder(path, {"marker", "1"}, ExistingOutput::replace); };
  EXPECT_EQ(error_kind(stage), ErrorKind::input);
  EXPECT_EQ(vo::read_file(folder.path() / "photos.part/holiday"), "precious");
}

}  // namespace
