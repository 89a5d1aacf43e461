#include "tools/processes/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <ftw.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Lets the owner write into a folder that nftw visits, without which what is in it cannot be
/// removed.
int make_writable(const char* path, const struct stat* status, int type, FTW* /*place*/) {
  if (type == FTW_D || type == FTW_DNR) {
    ::chmod(path, status->st_mode | S_IRWXU);  // or it stays
  }
  return 0;
}

void remove_with_contents(const fs::path& folder) noexcept {
  constexpr int kOpenFolders = 16;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): without FTW_CHDIR nothing is shared
  ::nftw(folder.c_str(), make_writable, kOpenFolders, FTW_PHYS);
  vo::remove_tree(folder);
}

constexpr const char* kPrefix = "edvo-";
constexpr const char* kLockSuffix = ".lock";

bool is_own_file(const fs::path& file) {
  struct stat status {};
  return ::lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         status.st_uid == ::geteuid();
}

/// Removes the folder of a lock file that nobody holds, and the file.
void remove_if_abandoned(const fs::path& lock_file) {
  const auto lock = vo::FileLock::try_lock(lock_file, vo::LockKind::exclusive);
  if (lock && lock->is_on(lock_file)) {
    remove_with_contents(fs::path(lock_file).replace_extension());
    lock->remove_if_alone(lock_file);
  }
}

/// Removes what killed processes of this user left.
void remove_abandoned_folders(const fs::path& place) {
  for (const auto& [name, kind] : vo::entries_of(place)) {
    if (name.starts_with(kPrefix) && name.ends_with(kLockSuffix) && is_own_file(place / name)) {
      try {
        remove_if_abandoned(place / name);
      } catch (const vo::Error&) {  // it has gone in between
      }
    }
  }
}

/// Returns the folder that the environment names for files of short life, the first of its
/// variables that is set and not empty, or /tmp. Throws Error naming the variable where there is no
/// such folder.
fs::path temporary_place() {
  for (const char* name : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing sets it
    if (value != nullptr && *value != '\0') {
      std::error_code ignored;
      vo::require(fs::is_directory(value, ignored), name, ": ", value,
                  " is no folder that can be entered, expected one for scratch files");
      return value;
    }
  }
  return "/tmp";
}

/// Makes a file `edvo-XXXXXX.lock` of a name that is free, locked before anybody else saw it.
std::pair<fs::path, vo::FileLock> new_lock_file(const fs::path& place) {
  for (;;) {
    std::string name = (place / (std::string(kPrefix) + "XXXXXX" + kLockSuffix)).string();
    const int file =
        ::mkostemps(name.data(), static_cast<int>(std::strlen(kLockSuffix)), O_CLOEXEC);
    if (file < 0) {
      vo::fail_with(place, "a scratch folder cannot be made", errno);
    }
    ::close(file);
    std::optional<vo::FileLock> lock = vo::FileLock::try_lock(name, vo::LockKind::exclusive);
    if (lock && lock->is_on(name)) {  // else somebody took it for abandoned
      return {name, std::move(*lock)};
    }
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  const fs::path place = temporary_place();
  remove_abandoned_folders(place);
  auto [file, lock] = new_lock_file(place);
  lock_file_ = file;
  lock_.emplace(std::move(lock));
  path_ = fs::path(lock_file_).replace_extension();
  if (::mkdir(path_.c_str(), S_IRWXU) != 0) {
    const int error = errno;
    lock_->remove_if_alone(lock_file_);
    vo::fail_with(path_, "cannot be made", error);
  }
}

ScratchFolder::~ScratchFolder() {
  remove_with_contents(path_);
  lock_->remove_if_alone(lock_file_);
}

}  // namespace tools
