#include "vo/files/file_lock.h"

#include <atomic>
#include <future>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace {

using support::TempFolder;
using vo::FileLock;
using vo::LockKind;

TEST(FileLock, IsHeldByManyShared) {
  const TempFolder folder;
  const auto file = folder.path() / "lock";
  const FileLock first(file, LockKind::shared, [] {});
  EXPECT_TRUE(FileLock::try_lock(file, LockKind::shared).has_value());
  EXPECT_FALSE(FileLock::try_lock(file, LockKind::exclusive).has_value());
}

TEST(FileLock, IsHeldByOneExclusivelyUntilItSharesOrEnds) {
  const TempFolder folder;
  const auto file = folder.path() / "lock";
  {
    const FileLock first(file, LockKind::exclusive, [] {});
    EXPECT_FALSE(FileLock::try_lock(file, LockKind::shared).has_value());
    first.share();
    EXPECT_TRUE(FileLock::try_lock(file, LockKind::shared).has_value());
  }
  EXPECT_TRUE(FileLock::try_lock(file, LockKind::exclusive).has_value());
}

TEST(FileLock, WaitsForTheOther) {
  const TempFolder folder;
  const auto file = folder.path() / "lock";
  auto first = std::make_unique<FileLock>(file, LockKind::exclusive, [] {});
  std::promise<void> is_waiting;
  std::atomic<int> waits = 0;
  auto second = std::async(std::launch::async, [&] {
    const FileLock lock(file, LockKind::exclusive, [&] {
      if (waits++ == 0) {
        is_waiting.set_value();
      }
    });
  });
  is_waiting.get_future().wait();
  first.reset();
  second.get();
  EXPECT_GE(waits, 1);
}

TEST(FileLock, GivesUpWhenItsWaiterThrows) {
  const TempFolder folder;
  const auto file = folder.path() / "lock";
  const FileLock first(file, LockKind::exclusive, [] {});
  EXPECT_EQ(support::error_text([&] {
              const FileLock second(file, LockKind::exclusive, [] { vo::fail("enough"); });
            }),
            "enough");
}

}  // namespace
