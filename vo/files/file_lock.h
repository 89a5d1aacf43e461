#pragma once

#include <filesystem>
#include <optional>

#include "vo/core/progress.h"

namespace vo {

enum class LockKind {
  shared,    ///< others may hold a shared lock, too
  exclusive  ///< nobody else holds a lock
};

/// A lock on a file (flock) between threads and processes. It is released with the object or when
/// the process ends, however it ends. The file stays; its modification time is that of the last
/// lock.
class FileLock {
 public:
  /// Creates the file and waits for the lock. Throws Error when either fails.
  FileLock(const std::filesystem::path& file, LockKind kind, const WaitObserver& waiting);

  /// Returns the lock, or nothing when somebody else holds it. Throws Error without a file.
  static std::optional<FileLock> try_lock(const std::filesystem::path& file, LockKind kind);

  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Changes the lock from exclusive to shared.
  void share() const;

  /// Returns whether a path still names the locked file, which somebody may have removed, renamed
  /// or replaced before the lock was there.
  bool is_on(const std::filesystem::path& file) const;

  /// Removes the locked file where this is the only lock on it and `file` still names it. The lock
  /// may be lost, so nothing but the destructor may follow.
  void remove_if_alone(const std::filesystem::path& file) const;

  int descriptor() const { return descriptor_; }  ///< open for reading and writing

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

/// Waits a moment before one looks again whether another process is done; calls `waiting` first.
void pause_for_others(const WaitObserver& waiting);

}  // namespace vo
