#include "vo/files/folder.h"

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace {

namespace fs = std::filesystem;

using support::TempFolder;
using testing::ElementsAre;
using testing::EndsWith;

std::vector<std::string> names_of(const std::vector<vo::FolderEntry>& entries) {
  std::vector<std::string> names;
  for (const vo::FolderEntry& entry : entries) {
    names.push_back(entry.name);
  }
  return names;
}

/// A folder with files, folders, a link to a file outside and one to its own folder.
class Folder : public testing::Test {
 protected:
  Folder() {
    outside_ = folder_.write("outside.txt", "kept");
    folder_.write("tree/b.txt", "1");
    folder_.write("tree/a/deep/c.txt", "22");
    folder_.write("tree/a/d.txt", "");
    fs::create_directory(tree() / "empty");
    fs::create_symlink(outside_, tree() / "link");
    fs::create_directory_symlink(tree(), tree() / "loop");
  }

  fs::path tree() const { return folder_.path() / "tree"; }

  TempFolder folder_;
  fs::path outside_;
};

TEST_F(Folder, EntriesAreThoseOfTheFolderAlone) {
  const std::vector<vo::FolderEntry> entries = vo::entries_of(tree());
  EXPECT_THAT(names_of(entries), ElementsAre("a", "b.txt", "empty", "link", "loop"));
  EXPECT_EQ(entries[0].kind, vo::EntryKind::folder);
  EXPECT_EQ(entries[1].kind, vo::EntryKind::file);
  EXPECT_EQ(entries[3].kind, vo::EntryKind::link);
  EXPECT_EQ(entries[4].kind, vo::EntryKind::link) << "a link is not what it leads to";
}

TEST_F(Folder, EntriesBelowAreThoseOfTheStandardLibrary) {
  std::vector<std::string> expected;
  for (const auto& entry : fs::recursive_directory_iterator(tree())) {
    expected.push_back(entry.path().lexically_relative(tree()).generic_string());
  }
  std::vector<std::string> names = names_of(vo::entries_below(tree()));
  const auto place = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  EXPECT_LT(place("a"), place("a/deep")) << "a folder comes before what it holds";
  EXPECT_LT(place("a/deep"), place("a/deep/c.txt"));
  std::sort(names.begin(), names.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names, expected);
}

TEST_F(Folder, RemoveTreeFollowsNoLink) {
  EXPECT_EQ(vo::remove_tree(tree()), 0);
  EXPECT_FALSE(fs::exists(tree()));
  EXPECT_TRUE(fs::exists(outside_));
  EXPECT_EQ(vo::remove_tree(outside_), 0) << "a file is removed, too";
  EXPECT_FALSE(fs::exists(outside_));
  EXPECT_EQ(vo::remove_tree(tree()), 0) << "nothing is there";
}

TEST_F(Folder, WhatCannotBeListedIsNamed) {
  EXPECT_THAT(support::error_text([&] { vo::entries_of(tree() / "none"); }),
              EndsWith("none: cannot be listed: No such file or directory"));
  EXPECT_THAT(support::error_text([&] { vo::entries_below(outside_); }),
              EndsWith("outside.txt: cannot be listed: Not a directory"));
}

}  // namespace
