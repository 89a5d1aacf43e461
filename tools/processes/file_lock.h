#pragma once

#include <filesystem>
#include <functional>
#include <optional>

namespace tools {

enum class LockKind {
  shared,    ///< others may hold a shared lock, too
  exclusive  ///< nobody else holds a lock
};

/// Callback that is called repeatedly while waiting; it may throw to stop.
using WaitObserver = std::function<void()>;

/// A lock on a file (flock) between threads and processes. It is released with the object or when
/// the process ends. The file stays; its modification time is that of the last lock.
class FileLock {
 public:
  /// Creates the file and waits for the lock. Throws vo::Error when either fails.
  FileLock(const std::filesystem::path& file, LockKind kind, const WaitObserver& waiting);

  /// Returns the lock, or nothing when somebody else holds it. Throws vo::Error without a file.
  static std::optional<FileLock> try_lock(const std::filesystem::path& file, LockKind kind);

  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Changes the lock from exclusive to shared.
  void share() const;

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

}  // namespace tools
