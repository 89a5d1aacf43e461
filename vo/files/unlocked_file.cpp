#include "vo/files/unlocked_file.h"

#include <chrono>

#include <fcntl.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/core/process_name.h"
#include "vo/files/folder.h"
#include "vo/files/partial_file.h"
#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOutputFails = "cannot be written";

/// Returns a name that no other writer has: by process and thread, whose numbers come again, and
/// time.
fs::path own_partial_name(const fs::path& path) {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return partial_name(concat(path.string(), ".", process_name(), "-", ::gettid(), "-", now));
}

/// Returns whether a file has a name that `own_partial_name` gave in a process that has ended.
bool is_abandoned(const std::string& name) {
  const std::size_t process = name.rfind("." + host_name() + "-");
  return is_partial_name(name) && process != std::string::npos &&
         is_of_ended_process(std::string_view(name).substr(process + 1));
}

/// A file that is removed unless it was renamed.
class OwnFile {
 public:
  explicit OwnFile(const fs::path& path)
      : path_(path), partial_(own_partial_name(path)), descriptor_(uninterrupted([&] {
          constexpr mode_t kMode = 0666;
          return ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
        })) {
    if (descriptor_ < 0) {
      fail_with(path_, kOutputFails, errno);
    }
  }

  ~OwnFile() {
    close();
    if (!is_renamed_) {
      ::unlink(partial_.c_str());
    }
  }

  OwnFile(const OwnFile&) = delete;
  OwnFile& operator=(const OwnFile&) = delete;
  OwnFile(OwnFile&&) = delete;
  OwnFile& operator=(OwnFile&&) = delete;

  void write(std::string_view bytes) const { write_bytes(descriptor_, bytes, path_); }

  /// Gives the file its name once it is closed: network file systems tell of a full disk only then.
  void rename(Durability durability) {
    const bool is_synced = durability == Durability::synced;
    if (is_synced && uninterrupted([&] { return ::fsync(descriptor_); }) != 0) {
      fail_with(path_, kOutputFails, errno);
    }
    if (close() != 0 || ::rename(partial_.c_str(), path_.c_str()) != 0) {
      fail_with(path_, kOutputFails, errno);
    }
    is_renamed_ = true;
    if (is_synced) {
      sync_to_disk(path_.parent_path());
    }
  }

 private:
  int close() {
    const int result = descriptor_ < 0 ? 0 : ::close(descriptor_);
    descriptor_ = -1;
    return result;
  }

  fs::path path_;
  fs::path partial_;
  int descriptor_;
  bool is_renamed_ = false;
};

}  // namespace

void write_unlocked(const fs::path& path, std::string_view bytes, Durability durability) {
  OwnFile file(path);
  file.write(bytes);
  file.rename(durability);
}

void remove_abandoned_unlocked(const fs::path& folder) {
  for (const FolderEntry& entry : entries_of(folder)) {
    if (entry.kind == EntryKind::file && is_abandoned(entry.name)) {
      ::unlink((folder / entry.name).c_str());
    }
  }
}

}  // namespace vo
