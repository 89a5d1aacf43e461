#include "vo/files/unlocked_file.h"

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/core/process_name.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"

namespace {

TEST(UnlockedFile, ReplacesWhatIsThere) {
  const support::TempFolder folder;
  const std::filesystem::path file = folder.write("a.txt", "before");
  vo::write_unlocked(file, "after", vo::Durability::synced);
  EXPECT_EQ(vo::read_file(file), "after");
  EXPECT_EQ(vo::entries_of(folder.path()).size(), 1U);
}

TEST(UnlockedFile, HasTheBytesOfOneOfItsWritersAtEveryMoment) {
  constexpr int kWriters = 4;
  constexpr int kTimes = 50;
  constexpr std::size_t kBytes = 20000;
  const support::TempFolder folder;
  const std::filesystem::path file = folder.write("a.txt", std::string(kBytes, 'a'));
  std::vector<std::thread> writers;
  for (int i = 0; i < kWriters; ++i) {
    writers.emplace_back([&, bytes = std::string(kBytes, static_cast<char>('a' + i))] {
      for (int k = 0; k < kTimes; ++k) {
        vo::write_unlocked(file, bytes, vo::Durability::unsynced);
      }
    });
  }
  for (int k = 0; k < kTimes; ++k) {
    const std::string bytes = vo::read_file(file);
    EXPECT_EQ(bytes, std::string(kBytes, bytes.front()));
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  EXPECT_EQ(vo::entries_of(folder.path()).size(), 1U);
}

TEST(UnlockedFile, WhatAKilledProcessLeftIsRemoved) {
  const support::TempFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  const auto left = [&](const std::string& process) {
    return folder.write("." + ("a.txt." + process) + "-7-1700000000.partial-edvo", "half");
  };
  const auto of_ended = left(vo::concat(vo::host_name(), "-", child));
  const auto of_this = left(vo::process_name());
  const auto of_another_machine = left(vo::concat("no-", vo::host_name(), "-", child));
  const auto of_a_user = folder.write("a.txt", "whole");
  vo::remove_abandoned_unlocked(folder.path());
  EXPECT_FALSE(std::filesystem::exists(of_ended));
  EXPECT_TRUE(std::filesystem::exists(of_this));
  EXPECT_TRUE(std::filesystem::exists(of_another_machine));
  EXPECT_TRUE(std::filesystem::exists(of_a_user));
}

TEST(UnlockedFile, AFolderThatIsNotThereIsNamed) {
  const support::TempFolder folder;
  const std::filesystem::path file = folder.path() / "none" / "a.txt";
  EXPECT_EQ(support::error_text([&] { vo::write_unlocked(file, "", vo::Durability::synced); }),
            file.string() + ": cannot be written: No such file or directory");
}

}  // namespace
