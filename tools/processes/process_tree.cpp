#include "tools/processes/process_tree.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <sys/wait.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/folder.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

/// Appends the children of a process, which each of its threads may have started.
void add_children(pid_t process, std::vector<pid_t>& processes) {
  const fs::path tasks = fs::path("/proc") / std::to_string(process) / "task";
  try {
    for (const vo::FolderEntry& task : vo::entries_of(tasks)) {
      std::ifstream children(tasks / task.name / "children");
      for (pid_t child = 0; children >> child;) {
        processes.push_back(child);
      }
    }
  } catch (const vo::Error&) {  // the process has gone in between
  }
}

/// Returns whether the process has a child, after reaping those that have ended.
bool has_children() {
  pid_t ended = 0;
  do {
    ended = ::waitpid(-1, nullptr, WNOHANG);
  } while (ended > 0 || (ended < 0 && errno == EINTR));
  return ended == 0;
}

void pause_briefly() {
  constexpr timespec kPause{.tv_sec = 0, .tv_nsec = 2'000'000};
  ::nanosleep(&kPause, nullptr);
}

}  // namespace

std::vector<pid_t> descendants_of(pid_t root) {
  std::vector<pid_t> processes;
  add_children(root, processes);
  for (std::size_t i = 0; i < processes.size(); ++i) {
    add_children(processes[i], processes);
  }
  return processes;
}

double private_memory(const std::vector<pid_t>& processes) {
  const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
  double bytes = 0;
  for (const pid_t process : processes) {
    std::ifstream file(fs::path("/proc") / std::to_string(process) / "statm");
    double size = 0;
    double resident = 0;
    double shared = 0;
    if (file >> size >> resident >> shared) {
      bytes += page * (resident - shared);
    }
  }
  return bytes;
}

void end_descendants(double time_limit) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(time_limit));
  while (has_children() && Clock::now() < end) {
    for (const pid_t process : descendants_of(::getpid())) {
      ::kill(process, SIGKILL);
    }
    pause_briefly();
  }
}

}  // namespace tools
