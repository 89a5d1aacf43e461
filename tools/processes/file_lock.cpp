#include "tools/processes/file_lock.h"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/core/error.h"

namespace tools {
namespace {

int open_lock(const std::filesystem::path& file) {
  constexpr mode_t kMode = 0666;
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
  vo::require(descriptor >= 0, file.string(),
              ": cannot be made: ", std::generic_category().message(errno));
  return descriptor;
}

bool lock_now(int descriptor, LockKind kind) {
  const int operation = kind == LockKind::shared ? LOCK_SH : LOCK_EX;
  if (::flock(descriptor, operation | LOCK_NB) != 0) {
    return false;
  }
  ::futimens(descriptor, nullptr);
  return true;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file, LockKind kind, const WaitObserver& waiting)
    : FileLock(open_lock(file)) {
  constexpr std::chrono::milliseconds kPause(50);
  while (!lock_now(descriptor_, kind)) {
    vo::require(errno == EWOULDBLOCK || errno == EINTR, file.string(),
                ": cannot be locked: ", std::generic_category().message(errno));
    waiting();
    std::this_thread::sleep_for(kPause);
  }
}

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& file, LockKind kind) {
  FileLock lock(open_lock(file));
  if (!lock_now(lock.descriptor_, kind)) {
    return {};
  }
  return lock;
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

}  // namespace tools
