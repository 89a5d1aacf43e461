#include "vo/files/file_lock.h"

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/files/system_failure.h"

namespace vo {
namespace {

int open_lock(const std::filesystem::path& file) {
  constexpr mode_t kMode = 0666;
  const int descriptor = uninterrupted(
      [&] { return ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kMode); });
  if (descriptor < 0) {
    fail_with(file, "cannot be made", errno);
  }
  return descriptor;
}

bool lock_now(int descriptor, LockKind kind) {
  const int operation = kind == LockKind::shared ? LOCK_SH : LOCK_EX;
  if (uninterrupted([&] { return ::flock(descriptor, operation | LOCK_NB); }) != 0) {
    return false;
  }
  ::futimens(descriptor, nullptr);
  return true;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file, LockKind kind, const WaitObserver& waiting)
    : FileLock(open_lock(file)) {
  while (!lock_now(descriptor_, kind)) {
    if (errno != EWOULDBLOCK) {
      fail_with(file, "cannot be locked", errno);
    }
    pause_for_others(waiting);
  }
}

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& file, LockKind kind) {
  FileLock lock(open_lock(file));
  if (lock_now(lock.descriptor_, kind)) {
    return lock;
  }
  if (errno != EWOULDBLOCK) {
    fail_with(file, "cannot be locked", errno);
  }
  return {};
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

void FileLock::share() const {
  ::flock(descriptor_, LOCK_SH);
}

bool FileLock::is_on(const std::filesystem::path& file) const {
  struct stat held {};
  struct stat named {};
  return ::fstat(descriptor_, &held) == 0 && ::lstat(file.c_str(), &named) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

void FileLock::remove_if_alone(const std::filesystem::path& file) const {
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && is_on(file)) {
    ::unlink(file.c_str());
  }
}

void pause_for_others(const WaitObserver& waiting) {
  constexpr std::chrono::milliseconds kPause(10);
  if (waiting) {
    waiting();
  }
  std::this_thread::sleep_for(kPause);
}

}  // namespace vo
