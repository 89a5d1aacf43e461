#include "vo/files/output_lock.h"

#include <utility>

namespace vo {
namespace {

namespace fs = std::filesystem;

fs::path lock_file_of(const fs::path& path) {
  return path.parent_path() / ("." + path.filename().string() + ".lock-edvo");
}

OutputLock waited_for(const fs::path& path, LockKind kind, const WaitObserver& waiting) {
  for (;;) {
    if (std::optional<OutputLock> lock = OutputLock::try_lock(path, kind)) {
      return std::move(*lock);
    }
    pause_for_others(waiting);
  }
}

}  // namespace

OutputLock::OutputLock(fs::path file, FileLock lock)
    : file_(std::move(file)), lock_(std::move(lock)) {}

OutputLock::OutputLock(const fs::path& path, LockKind kind, const WaitObserver& waiting)
    : OutputLock(waited_for(path, kind, waiting)) {}

std::optional<OutputLock> OutputLock::try_lock(const fs::path& path, LockKind kind) {
  const fs::path file = lock_file_of(path);
  for (;;) {
    std::optional<FileLock> lock = FileLock::try_lock(file, kind);
    if (!lock) {
      return {};
    }
    if (lock->is_on(file)) {  // else its last owner has just removed it
      return OutputLock(file, std::move(*lock));
    }
  }
}

OutputLock::~OutputLock() {
  if (lock_.descriptor() >= 0) {
    lock_.remove_if_alone(file_);
  }
}

}  // namespace vo
