#include "vo/files/unlocked_file.h"

#include <array>
#include <chrono>

#include <fcntl.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/partial_file.h"
#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOutputFails = "cannot be written";

/// Returns a name that no other writer has: by machine and thread, whose numbers come again, and
/// time.
fs::path own_partial_name(const fs::path& path) {
  std::array<char, 256> machine{};
  if (::gethostname(machine.data(), machine.size() - 1) != 0) {
    machine.fill('\0');
  }
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return partial_name(concat(path.string(), ".", machine.data(), "-", ::gettid(), "-", now));
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

}  // namespace vo
