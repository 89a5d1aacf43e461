#pragma once

#include <filesystem>
#include <optional>

#include "vo/files/file_lock.h"

namespace vo {

/// The right to make one output, from before its first file until it has its name: a lock on the
/// file `.NAME.lock-edvo` beside it. The file goes with the last lock on it; one that a killed
/// process leaves is taken over, and goes with the next run's.
class OutputLock {
 public:
  /// Waits until the lock is there. Throws Error where there can be none.
  OutputLock(const std::filesystem::path& path, LockKind kind, const WaitObserver& waiting);

  /// Returns nothing when somebody else holds the lock.
  static std::optional<OutputLock> try_lock(const std::filesystem::path& path, LockKind kind);

  ~OutputLock();
  OutputLock(OutputLock&& other) noexcept = default;
  OutputLock& operator=(OutputLock&&) = delete;
  OutputLock(const OutputLock&) = delete;
  OutputLock& operator=(const OutputLock&) = delete;

  /// Lets others share the lock. Somebody may hold it alone in between, so what was seen before may
  /// no longer be.
  void share() const { lock_.share(); }

 private:
  OutputLock(std::filesystem::path file, FileLock lock);

  std::filesystem::path file_;
  FileLock lock_;
};

}  // namespace vo
