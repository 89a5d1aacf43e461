#include "tools/cli/interrupt.h"

#include <atomic>
#include <csignal>

#include "vo/core/error.h"

namespace tools {
namespace {

std::atomic<int>& received_signal() {
  static std::atomic<int> signal = 0;
  static_assert(std::atomic<int>::is_always_lock_free, "a handler may not lock");
  return signal;
}

extern "C" void remember(int signal) {
  received_signal() = signal;
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
  received_signal() = 0;
  remember_unless_ignored(SIGINT);
  remember_unless_ignored(SIGHUP);
  std::signal(SIGTERM, remember);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_DFL);
}

bool is_interrupted() {
  return received_signal() != 0;
}

void throw_if_interrupted() {
  switch (received_signal()) {
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
