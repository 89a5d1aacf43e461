#include "tools/cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "vo/core/error.h"

namespace tools {
namespace {

/// The last signal that was recorded, 0 before the first, and when the first came.
struct ReceivedSignals {
  std::atomic<int> last = 0;
  std::atomic<std::int64_t> first_ns = 0;
  static_assert(std::atomic<int>::is_always_lock_free &&
                    std::atomic<std::int64_t>::is_always_lock_free,
                "a handler may not lock");
};

ReceivedSignals& received() {
  static ReceivedSignals signals;
  return signals;
}

std::int64_t monotonic_ns() {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;  // a second
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kNanoseconds + now.tv_nsec;
}

/// Calls nothing but what POSIX lets a handler call.
extern "C" void remember(int signal) {
  const std::int64_t now = monotonic_ns();
  if (received().last == 0) {
    received().first_ns = now;
  } else if (now - received().first_ns >= kSameRequestNs) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // it is blocked until the handler returns, and ends the process then
  }
  received().last = signal;
}

/// Lets `remember` handle a signal unless the process was started with it ignored, as by nohup.
void remember_unless_ignored(int signal) {
  struct sigaction inherited {};
  if (::sigaction(signal, nullptr, &inherited) != 0 || inherited.sa_handler != SIG_IGN) {
    std::signal(signal, remember);
  }
}

}  // namespace

void remember_signals() {
  received().last = 0;
  remember_unless_ignored(SIGINT);
  remember_unless_ignored(SIGHUP);
  std::signal(SIGTERM, remember);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_DFL);
}

bool is_interrupted() {
  return received().last != 0;
}

void throw_if_interrupted() {
  switch (received().last) {
    case SIGINT:
      vo::fail_as(vo::ErrorKind::interrupted, "interrupted");
    case SIGTERM:
    case SIGHUP:
      vo::fail_as(vo::ErrorKind::temporary, "terminated");
    default:
      return;
  }
}

}  // namespace tools
