#include "vo/files/writable_stream.h"

#include <cerrno>
#include <climits>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/files/file_lock.h"
#include "vo/files/output.h"
#include "vo/files/system_failure.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNotWritable = "cannot be written";

int open_stream(const fs::path& path, const WaitObserver& waiting) {
  if (path == kStdoutPath) {
    return ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  }
  constexpr int kFlags = O_WRONLY | O_CLOEXEC | O_CREAT | O_TRUNC | O_NONBLOCK;
  constexpr mode_t kMode = 0666;
  for (;;) {
    const int descriptor = uninterrupted([&] { return ::open(path.c_str(), kFlags, kMode); });
    if (descriptor >= 0 || errno != ENXIO || !fs::is_fifo(path)) {
      return descriptor;
    }
    pause_for_others(waiting);
  }
}

/// Returns how many bytes can be written at once without waiting when `poll` says that there is
/// room: a pipe takes PIPE_BUF, of files and devices any number is asked for.
std::size_t greatest_part(int descriptor) {
  struct stat status {};
  const bool is_pipe = ::fstat(descriptor, &status) == 0 && S_ISFIFO(status.st_mode);
  return is_pipe ? PIPE_BUF : SSIZE_MAX;
}

}  // namespace

WritableStream::WritableStream(fs::path path, WaitObserver waiting)
    : path_(std::move(path)),
      waiting_(std::move(waiting)),
      descriptor_(open_stream(path_, waiting_)) {
  if (descriptor_ < 0) {
    fail_with(path_, kNotWritable, errno);
  }
}

WritableStream::~WritableStream() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

void WritableStream::append(std::string_view bytes) {
  const std::size_t part = greatest_part(descriptor_);
  while (!bytes.empty()) {
    wait_for_room();
    const std::string_view next = bytes.substr(0, part);
    const ssize_t written = ::write(descriptor_, next.data(), next.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR && errno != EAGAIN) {
      fail_with(path_, kNotWritable, errno);
    }
  }
}

void WritableStream::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail_with(path_, kNotWritable, errno);
  }
}

void WritableStream::wait_for_room() const {
  constexpr int kWaitMs = 100;
  pollfd ready{.fd = descriptor_, .events = POLLOUT, .revents = 0};
  while (::poll(&ready, 1, kWaitMs) <= 0) {
    if (waiting_) {
      waiting_();
    }
  }
}

}  // namespace vo
