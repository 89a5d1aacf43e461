#pragma once

#include <filesystem>
#include <functional>
#include <optional>

namespace tools {

enum class LockKind {
  shared,    ///< others may hold it shared, too
  exclusive  ///< nobody else holds it
};

/// Told again and again while waiting; may throw to stop.
using WaitObserver = std::function<void()>;

/// A lock on a file (flock) between threads and processes. It ends with the object and with the
/// process, however that ends. The file stays; its modification time is when it was last locked.
class FileLock {
 public:
  /// Makes the file and waits. Throws vo::Error when the file cannot be made.
  FileLock(const std::filesystem::path& file, LockKind kind, const WaitObserver& waiting);

  /// Nothing when somebody else holds it.
  static std::optional<FileLock> try_lock(const std::filesystem::path& file, LockKind kind);

  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// From exclusive to shared, without anybody coming in between.
  void share() const;

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

}  // namespace tools
