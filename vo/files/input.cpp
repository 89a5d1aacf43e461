#include "vo/files/input.h"

#include <algorithm>
#include <cerrno>
#include <new>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/partial_file.h"
#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

std::string_view kind_of(mode_t mode) {
  if (S_ISDIR(mode)) {
    return "a folder";
  }
  if (S_ISFIFO(mode)) {
    return "a pipe";
  }
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

/// Owns an open file.
class OpenFile {
 public:
  /// Opens without waiting, which a pipe without a writer would have one do.
  explicit OpenFile(const fs::path& path)
      : path_(path), descriptor_(uninterrupted([&] {
          return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        })) {
    require(descriptor_ >= 0 || errno != ENOENT, path.string(), ": there is no such file");
    if (descriptor_ < 0) {
      fail_with(path, "cannot be read", errno);
    }
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(OpenFile&&) = delete;
  OpenFile& operator=(OpenFile&&) = delete;

  /// Returns the size of the regular file, bytes.
  std::uintmax_t size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) {
      fail_with(path_, "cannot be read", errno);
    }
    require(S_ISREG(status.st_mode), path_.string(), ": is ", kind_of(status.st_mode),
            ", expected a regular file");
    return static_cast<std::uintmax_t>(status.st_size);
  }

  /// Fills `bytes` from the file's start; it becomes shorter where the file is.
  void read(std::string& bytes) const {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = ::read(descriptor_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno != EINTR) {
        fail_with(path_, "cannot be read to its end", errno);
      }
      if (count == 0) {
        break;
      }
      done += static_cast<std::size_t>(count > 0 ? count : 0);
    }
    bytes.resize(done);
  }

 private:
  const fs::path& path_;
  int descriptor_;
};

bool is_within(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

std::string read_file(const fs::path& path, std::uintmax_t max_bytes) {
  const OpenFile file(path);
  const std::uintmax_t size = file.size();
  require(size <= max_bytes, path.string(), ": has ", size, " bytes, expected at most ", max_bytes);
  std::string bytes;
  try {
    bytes.resize(size);
  } catch (const std::bad_alloc&) {
    fail_as(ErrorKind::temporary, path.string(), ": reading it needs ", size,
            " bytes of memory, which are not there");
  }
  file.read(bytes);
  return bytes;
}

void copy_stream(int from, int to, const std::string& name, std::uintmax_t max_bytes,
                 const WaitObserver& waiting) {
  constexpr std::size_t kPartBytes = 1 << 20;
  constexpr int kWaitMs = 100;
  std::string part(kPartBytes, '\0');
  std::uintmax_t size = 0;
  for (;;) {
    waiting();
    pollfd ready{.fd = from, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, kWaitMs) <= 0) {
      continue;
    }
    const ssize_t count = ::read(from, part.data(), part.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) {
      continue;
    }
    if (count < 0) {
      fail_with(name, "cannot be read", errno);
    }
    if (count == 0) {
      return;
    }
    size += static_cast<std::uintmax_t>(count);
    require(size <= max_bytes, name, ": gives more than ", max_bytes,
            " bytes, expected at most those");
    write_bytes(to, std::string_view(part).substr(0, static_cast<std::size_t>(count)), name);
  }
}

bool leads_out(const fs::path& folder, const fs::path& relative) {
  fs::path path = folder;
  std::error_code error;
  for (const fs::path& part : relative) {
    path /= part;
    if (fs::symlink_status(path, error).type() == fs::file_type::symlink) {
      const fs::path home = fs::canonical(folder.empty() ? "." : folder, error);
      const fs::path target = fs::weakly_canonical(path, error);
      return !is_within(home, target);
    }
  }
  return false;
}

fs::path path_in(const fs::path& folder, const std::string& name, const std::string& place) {
  const fs::path relative = fs::path(name).lexically_normal();
  require(!relative.is_absolute() && *relative.begin() != "..", place, ": '", name,
          "' leads out of ", folder.string(), ", expected a file in it");
  require(!leads_out(folder, relative), place, ": '", name, "' leads by a symbolic link out of ",
          folder.string(), ", expected a file in it");
  return folder / relative;
}

}  // namespace vo
