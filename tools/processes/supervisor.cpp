#include "tools/processes/supervisor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include <fcntl.h>
#include <linux/close_range.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/processes/process_tree.h"

namespace tools {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kWatchPeriod(0.1);  // between two looks at memory and processes
constexpr std::size_t kTail = 4096;   // bytes

/// Returns pointers to the texts with a null pointer at the end, as exec takes them.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  pointers.push_back(nullptr);
  return pointers;
}

void limit_files(double bytes) {
  const auto size = std::isfinite(bytes) ? static_cast<rlim_t>(bytes) : RLIM_INFINITY;
  const rlimit file{.rlim_cur = size, .rlim_max = size};
  const rlimit none{.rlim_cur = 0, .rlim_max = 0};
  ::setrlimit(RLIMIT_FSIZE, &file);
  ::setrlimit(RLIMIT_CORE, &none);
}

void restore_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) {
    std::signal(signal, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);  // NOLINT(concurrency-mt-unsafe): one thread
}

/// Becomes the program. Writes errno to `failure`, which a successful exec closes, and ends
/// otherwise.
[[noreturn]] void become(const ChildCommand& command, const ChildLimits& limits, int output,
                         int failure) {
  constexpr int kNotStarted = 127;
  std::vector<std::string> words = command.words;
  std::vector<std::string> environment = command.environment.value_or(std::vector<std::string>());
  ::setsid();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  restore_signals();
  limit_files(limits.file);
  enter_view(command.view);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const bool is_there = command.folder.empty() || ::chdir(command.folder.c_str()) == 0;
  if (is_there && ::dup2(input, STDIN_FILENO) >= 0 && ::dup2(output, STDOUT_FILENO) >= 0 &&
      ::dup2(output, STDERR_FILENO) >= 0) {
    ::syscall(SYS_close_range, STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
    ::execvpe(words.front().c_str(), pointers_to(words).data(),
              command.environment ? pointers_to(environment).data() : environ);
  }
  const int error = errno;
  static_cast<void>(::write(failure, &error, sizeof(error)));
  ::_exit(kNotStarted);
}

/// The running program, as its supervisor sees it.
class Supervision {
 public:
  Supervision(const ChildCommand& command, const ChildLimits& limits, int control)
      : limits_(limits), control_(control) {
    std::array<int, 2> output{};
    std::array<int, 2> failure{};
    if (::pipe2(output.data(), O_CLOEXEC) != 0 || ::pipe2(failure.data(), O_CLOEXEC) != 0) {
      message_.start_error = errno;
      return;
    }
    signals_ = block_child_signal();
    program_ = ::fork();
    if (program_ == 0) {
      become(command, limits, output[1], failure[1]);
    }
    message_.start_error = program_ < 0 ? errno : 0;
    ::close(output[1]);
    ::close(failure[1]);
    if (program_ > 0 && ::read(failure[0], &message_.start_error, sizeof(int)) <= 0) {
      message_.start_error = 0;
    }
    ::close(failure[0]);
    output_ = output[0];
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
  }

  /// Returns when the program has ended, exceeded a limit or is no longer wanted.
  void watch() {
    while (message_.start_error == 0 && !has_ended() && !exceeds_limit()) {
      std::array<pollfd, 3> events{
          {{control_, POLLIN, 0}, {output_, POLLIN, 0}, {signals_, POLLIN, 0}}};
      ::poll(events.data(), events.size(), milliseconds_to_wait());
      if (events[0].revents != 0) {
        return;
      }
      if (events[2].revents != 0) {
        signalfd_siginfo ignored{};
        static_cast<void>(::read(signals_, &ignored, sizeof(ignored)));
      }
      read_output();
    }
  }

  /// Sends the message and the tail of the output.
  void report() {
    while (read_output()) {
    }
    static_cast<void>(::write(control_, &message_, sizeof(message_)));
    static_cast<void>(::write(control_, tail_.data(), tail_.size()));
  }

 private:
  static int block_child_signal() {
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    ::sigprocmask(SIG_BLOCK, &child, nullptr);  // NOLINT(concurrency-mt-unsafe): one thread
    return ::signalfd(-1, &child, SFD_CLOEXEC | SFD_NONBLOCK);
  }

  /// Reaps what has ended, adopted processes included.
  bool has_ended() {
    int status = 0;
    for (pid_t ended = 0; (ended = ::waitpid(-1, &status, WNOHANG)) > 0;) {
      if (ended == program_) {
        message_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
        message_.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        return true;
      }
    }
    return false;
  }

  bool exceeds_limit() {
    const Clock::time_point now = Clock::now();
    if (printed_ > limits_.output) {
      message_.exceeded = ExceededLimit::output;
    } else if (Seconds(now - start_).count() > limits_.time) {
      message_.exceeded = ExceededLimit::time;
    } else if (now >= next_look_) {
      next_look_ = now + std::chrono::duration_cast<Clock::duration>(kWatchPeriod);
      look_at_processes();
    }
    return message_.exceeded != ExceededLimit::none;
  }

  void look_at_processes() {
    if (!std::isfinite(limits_.memory) && !std::isfinite(limits_.processes)) {
      return;
    }
    const std::vector<pid_t> processes = descendants_of(::getpid());
    if (static_cast<double>(processes.size()) > limits_.processes) {
      message_.exceeded = ExceededLimit::processes;
    } else if (private_memory(processes) > limits_.memory) {
      message_.exceeded = ExceededLimit::memory;
    }
  }

  int milliseconds_to_wait() const {
    constexpr double kMilliseconds = 1000;
    const Seconds left = Seconds(limits_.time) - (Clock::now() - start_);
    return 1 + static_cast<int>(kMilliseconds * std::clamp(left, Seconds(0), kWatchPeriod).count());
  }

  /// Reads a block of what there is; returns whether there was something.
  bool read_output() {
    std::array<char, 65536> block{};
    const ssize_t count = output_ < 0 ? 0 : ::read(output_, block.data(), block.size());
    if (count == 0 && output_ >= 0) {
      ::close(output_);
      output_ = -1;  // ignored by poll
    }
    if (count <= 0) {
      return false;
    }
    printed_ += static_cast<double>(count);
    tail_.append(block.data(), static_cast<std::size_t>(count));
    tail_.erase(0, tail_.size() - std::min(tail_.size(), kTail));
    return true;
  }

  const ChildLimits& limits_;
  int control_;
  int output_ = -1;
  int signals_ = -1;
  pid_t program_ = -1;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_look_ = Clock::now();
  double printed_ = 0;  ///< bytes
  std::string tail_;
  SupervisorMessage message_;
};

/// Leaves the terminal's process group, so that only the other process hears of Ctrl-C.
void ignore_interruption() {
  ::setpgid(0, 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    std::signal(signal, SIG_IGN);
  }
}

}  // namespace

void supervise(const ChildCommand& command, const ChildLimits& limits, int control) {
  constexpr double kPatience = 10;  // s
  ignore_interruption();
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  Supervision supervision(command, limits, control);
  supervision.watch();
  end_descendants(kPatience);
  supervision.report();
  ::_exit(0);
}

}  // namespace tools
