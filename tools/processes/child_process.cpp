#include "tools/processes/child_process.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/processes/supervisor.h"
#include "vo/core/error.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

[[noreturn]] void fail_to_start(const ChildCommand& command, int error) {
  vo::fail_with(command.words.front(), "cannot be started", error);
}

/// A supervisor and the socket to it; the destructor closes the socket, at which the supervisor
/// kills the program and ends, and waits for that.
class Supervised {
 public:
  Supervised(const ChildCommand& command, const ChildLimits& limits) {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
      fail_to_start(command, errno);
    }
    supervisor_ = ::fork();
    const int error = errno;
    if (supervisor_ == 0) {
      ::close(sockets[0]);
      supervise(command, limits, sockets[1]);
    }
    ::close(sockets[1]);
    control_ = sockets[0];
    if (supervisor_ < 0) {
      ::close(control_);
      fail_to_start(command, error);
    }
  }

  ~Supervised() {
    ::close(control_);
    ::waitpid(supervisor_, nullptr, 0);
  }

  Supervised(const Supervised&) = delete;
  Supervised& operator=(const Supervised&) = delete;
  Supervised(Supervised&&) = delete;
  Supervised& operator=(Supervised&&) = delete;

  /// Returns what the supervisor wrote until it ended.
  std::string wait(const vo::WaitObserver& waiting) const {
    constexpr int kPause = 100;  // ms
    std::string bytes;
    for (;;) {
      waiting();
      pollfd event{control_, POLLIN, 0};
      if (::poll(&event, 1, kPause) <= 0) {
        continue;
      }
      std::array<char, 8192> block{};
      const ssize_t count = ::read(control_, block.data(), block.size());
      if (count <= 0) {
        return bytes;
      }
      bytes.append(block.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  pid_t supervisor_ = -1;
  int control_ = -1;
};

}  // namespace

ChildEnd run_child(const ChildCommand& command, const ChildLimits& limits,
                   const vo::WaitObserver& waiting) {
  vo::require(!command.words.empty(), "expected a program to start");
  const std::string bytes = Supervised(command, limits).wait(waiting);
  SupervisorMessage message;
  vo::require(bytes.size() >= sizeof(message), command.words.front(),
              ": its supervising process was killed");
  std::memcpy(&message, bytes.data(), sizeof(message));
  if (message.start_error != 0) {
    fail_to_start(command, message.start_error);
  }
  return {.exit_code = message.exit_code,
          .signal = message.signal,
          .exceeded = message.exceeded,
          .tail = bytes.substr(sizeof(message))};
}

}  // namespace tools
