#include "vo/files/partial_file.h"

#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "vo/files/folder.h"
#include "vo/files/output_lock.h"
#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPartialSuffix = ".partial-edvo";
constexpr const char* kNotWritten = "cannot be written";

/// Waits until an open file is on the disk; does nothing for what cannot be synced, as folders on
/// some file systems.
void sync_descriptor(int descriptor, const fs::path& path) {
  if (uninterrupted([&] { return ::fsync(descriptor); }) != 0 && errno != EINVAL &&
      errno != EROFS) {
    fail_with(path, kNotWritten, errno);
  }
}

/// Returns nothing when somebody else holds the lock. Throws Error that speaks of writing.
std::optional<FileLock> lock_to_write(const fs::path& file) {
  try {
    return FileLock::try_lock(file, LockKind::exclusive);
  } catch (const Error& error) {
    throw Error(concat(error.what(), ", so the output ", kNotWritten), error.kind());
  }
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(path, ignored));
}

/// Removes the folder that a killed process left under the partial name of `path` when it made a
/// folder of that name. Returns false where a process that lives makes it. Throws Error where it
/// cannot be removed.
bool remove_abandoned_folder(const fs::path& path) {
  const fs::path partial = partial_name(path);
  if (!is_folder(partial)) {
    return true;
  }
  const auto lock = OutputLock::try_lock(path, LockKind::exclusive);
  if (!lock) {
    return false;
  }
  if (is_folder(partial)) {
    remove_completely(partial);
  }
  return true;
}

}  // namespace

fs::path partial_name(const fs::path& path, const fs::path& extension) {
  return path.parent_path() /
         ("." + path.filename().string() + kPartialSuffix + extension.string());
}

bool is_partial_name(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') && name.ends_with(kPartialSuffix);
}

PartialFile::PartialFile(fs::path path, fs::path partial, FileLock lock)
    : path_(std::move(path)), partial_(std::move(partial)), lock_(std::move(lock)) {}

std::optional<PartialFile> PartialFile::try_open(const fs::path& path, const fs::path& extension) {
  const fs::path partial = partial_name(path, extension);
  for (;;) {
    if (!remove_abandoned_folder(path)) {
      return {};
    }
    std::optional<FileLock> lock = lock_to_write(partial);
    if (!lock) {
      return {};
    }
    if (lock->is_on(partial)) {  // else its writer has just renamed or removed it
      return PartialFile(path, partial, std::move(*lock));
    }
  }
}

PartialFile::PartialFile(const fs::path& path, const fs::path& extension,
                         const WaitObserver& waiting)
    : PartialFile([&] {
        constexpr int kLooks = 6000;
        for (int look = 0; look < kLooks; ++look) {
          if (std::optional<PartialFile> file = try_open(path, extension)) {
            return std::move(*file);
          }
          pause_for_others(waiting);
        }
        fail_as(ErrorKind::temporary, path.string(),
                ": another process has been writing it for long");
      }()) {}

PartialFile::PartialFile(PartialFile&& other) noexcept
    : path_(std::move(other.path_)),
      partial_(std::move(other.partial_)),
      lock_(std::move(other.lock_)),
      is_begun_(other.is_begun_) {
  other.lock_.reset();
}

PartialFile::~PartialFile() {
  if (lock_) {
    ::unlink(partial_.c_str());
  }
}

void PartialFile::append(std::string_view bytes) {
  if (!is_begun_ && ::ftruncate(lock_->descriptor(), 0) != 0) {
    fail_with(path_, kNotWritten, errno);
  }
  is_begun_ = true;
  write_bytes(lock_->descriptor(), bytes, path_);
}

void PartialFile::commit(Durability durability) {
  append({});
  if (durability == Durability::synced) {
    sync_descriptor(lock_->descriptor(), path_);
  }
  if (::rename(partial_.c_str(), path_.c_str()) != 0) {
    fail_with(path_, kNotWritten, errno);
  }
  lock_.reset();  // the name is no longer this file's
  if (durability == Durability::synced) {
    sync_to_disk(path_.parent_path());
  }
}

void PartialFile::commit(std::string_view bytes, Durability durability) {
  append(bytes);
  commit(durability);
}

void remove_abandoned(const fs::path& path) {
  const fs::path partial = partial_name(path);
  std::error_code ignored;
  if (fs::is_regular_file(fs::symlink_status(partial, ignored)) || is_folder(partial)) {
    PartialFile::try_open(path);
  }
}

void write_bytes(int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written =
        uninterrupted([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
    if (written < 0) {
      fail_with(path, kNotWritten, errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void sync_to_disk(const fs::path& path) {
  const int descriptor =
      uninterrupted([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW); });
  if (descriptor < 0) {
    fail_with(path, kNotWritten, errno);
  }
  try {
    sync_descriptor(descriptor, path);
  } catch (const Error&) {
    ::close(descriptor);
    throw;
  }
  ::close(descriptor);
}

}  // namespace vo
