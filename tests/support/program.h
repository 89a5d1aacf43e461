#pragma once

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <sys/wait.h>

#include "tests/support/temp_folder.h"
#include "vo/files/input.h"

namespace support {

/// What a run of the program left.
struct ProgramResult {
  int exit_code = 0;
  std::string out;
  std::string err;
};

/// Runs the program with arguments as a shell reads them, in a shell that `before` has prepared
/// (`ulimit -f 8; `). Signals that the tests were started to ignore, as by nohup or in the
/// background of a script, are not ignored by the program: some tests end it by SIGINT.
inline ProgramResult run_program(const std::string& arguments, const std::string& before = "") {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
  const TempFolder folder;
  const std::filesystem::path out = folder.write("out", "");
  const std::filesystem::path err = folder.write("err", "");
  const std::string command = before + "'" + EDVO_PROGRAM + "' " + arguments + " >'" +
                              out.string() + "' 2>'" + err.string() + "'";
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, vo::read_file(out), vo::read_file(err)};
}

/// Returns whether something unfinished lies in a folder.
inline bool has_leftovers(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    for (const char* mark : {".partial-edvo", ".lock-edvo", ".old-edvo"}) {
      if (name.find(mark) != std::string::npos) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace support
