#include "tools/processes/child_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "vo/core/error.h"

namespace tools {
namespace {

using Clock = std::chrono::steady_clock;

/// Settings of posix_spawn: own process group, default signal handlers, no input, output to a file.
class SpawnSettings {
 public:
  explicit SpawnSettings(const std::filesystem::path& output) {
    constexpr mode_t kMode = 0666;
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
    sigset_t defaults;
    sigemptyset(&defaults);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) {
      sigaddset(&defaults, signal);
    }
    posix_spawnattr_setsigdefault(&attributes_, &defaults);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, kMode);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }

  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  SpawnSettings(SpawnSettings&&) = delete;
  SpawnSettings& operator=(SpawnSettings&&) = delete;

  pid_t spawn(std::string command) {
    std::string shell = "/bin/sh";
    std::string flag = "-c";
    const std::array<char*, 4> words{shell.data(), flag.data(), command.data(), nullptr};
    pid_t process = 0;
    const int error =
        posix_spawn(&process, shell.c_str(), &actions_, &attributes_, words.data(), environ);
    vo::require(error == 0, command,
                ": cannot be started: ", std::generic_category().message(error));
    return process;
  }

 private:
  posix_spawnattr_t attributes_{};
  posix_spawn_file_actions_t actions_{};
};

/// Owns a process group; its destructor kills the group and waits for the leader.
class ProcessGroup {
 public:
  explicit ProcessGroup(pid_t leader) : leader_(leader) {}

  ~ProcessGroup() {
    ::kill(-leader_, SIGKILL);
    if (!has_ended_) {
      ::waitpid(leader_, nullptr, 0);
    }
  }

  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ProcessGroup(ProcessGroup&&) = delete;
  ProcessGroup& operator=(ProcessGroup&&) = delete;

  /// Returns whether the leader has ended, and stores how in `end`.
  bool has_ended(ChildEnd& end) {
    int status = 0;
    if (::waitpid(leader_, &status, WNOHANG) != leader_) {
      return false;
    }
    has_ended_ = true;
    end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return true;
  }

 private:
  pid_t leader_;
  bool has_ended_ = false;
};

}  // namespace

ChildEnd run_child(const std::string& command, const std::filesystem::path& output,
                   double time_limit, const WaitObserver& waiting) {
  constexpr std::chrono::milliseconds kPause(20);
  const Clock::time_point start = Clock::now();
  ProcessGroup group(SpawnSettings(output).spawn(command));
  ChildEnd end;
  while (!group.has_ended(end)) {
    const std::chrono::duration<double> elapsed = Clock::now() - start;
    if (elapsed.count() > time_limit) {
      end.timed_out = true;
      break;
    }
    waiting();
    std::this_thread::sleep_for(kPause);
  }
  return end;
}

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace tools
