#include "tools/processes/foreground.h"

#include <cerrno>
#include <csignal>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/file_lock.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

/// Starts the program; returns its process.
pid_t start_in_foreground(const ChildCommand& command) {
  std::vector<std::string> words = command.words;
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  if (!command.folder.empty()) {
    ::posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());
  }
  pid_t process = -1;
  const int error =
      ::posix_spawnp(&process, words.front().c_str(), &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    vo::fail_with(words.front(), "cannot be started", error);
  }
  return process;
}

int exit_code_of(int status) {
  constexpr int kEndedBySignal = 128;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kEndedBySignal + WTERMSIG(status);
}

}  // namespace

int run_in_foreground(const ChildCommand& command, const vo::WaitObserver& waiting) {
  vo::require(!command.words.empty(), "expected a program to start");
  const pid_t process = start_in_foreground(command);
  int status = 0;
  try {
    while (::waitpid(process, &status, WNOHANG) != process) {
      vo::pause_for_others(waiting);
    }
  } catch (...) {
    ::kill(process, SIGTERM);
    vo::uninterrupted([&] { return ::waitpid(process, &status, 0); });
    throw;
  }
  return exit_code_of(status);
}

}  // namespace tools
