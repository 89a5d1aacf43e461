#include "vo/files/ranged_file.h"

#include <algorithm>
#include <cerrno>
#include <new>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/core/error.h"
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

/// Returns the size of the regular file, bytes.
std::uintmax_t regular_size(int descriptor, const fs::path& path) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    fail_with(path, "cannot be read", errno);
  }
  require(S_ISREG(status.st_mode), path.string(), ": is ", kind_of(status.st_mode),
          ", expected a regular file");
  return static_cast<std::uintmax_t>(status.st_size);
}

[[noreturn]] void fail_to_open(const fs::path& path, int error) {
  require(error != ENOENT, path.string(), ": there is no such file");
  struct stat status {};
  if (error == ENXIO && ::stat(path.c_str(), &status) == 0) {  // as of a socket
    fail(path.string(), ": is ", kind_of(status.st_mode), ", expected a regular file");
  }
  fail_with(path, "cannot be read", error);
}

/// Returns memory for so many bytes of a file.
std::string room_for(std::uintmax_t count, const fs::path& path) {
  try {
    return std::string(count, '\0');
  } catch (const std::bad_alloc&) {
    fail_as(ErrorKind::temporary, path.string(), ": reading it needs ", count,
            " bytes of memory, which are not there");
  }
}

}  // namespace

RangedFile::RangedFile(fs::path path)
    : path_(std::move(path)),
      descriptor_(
          uninterrupted([&] { return ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); })) {
  if (descriptor_ < 0) {
    fail_to_open(path_, errno);
  }
  try {
    size_ = regular_size(descriptor_, path_);
  } catch (const Error&) {
    ::close(descriptor_);
    throw;
  }
}

RangedFile::~RangedFile() {
  ::close(descriptor_);
}

std::string RangedFile::read(std::uintmax_t offset, std::uintmax_t count) const {
  const std::uintmax_t there = offset < size_ ? size_ - offset : 0;
  std::string bytes = room_for(std::min(count, there), path_);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t read = uninterrupted([&] {
      return ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                     static_cast<off_t>(offset + done));
    });
    if (read < 0) {
      fail_with(path_, "cannot be read to its end", errno);
    }
    if (read == 0) {
      break;
    }
    done += static_cast<std::size_t>(read);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace vo
