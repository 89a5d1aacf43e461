#include "tools/processes/printed.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <unistd.h>

#include "tools/processes/scratch_folder.h"
#include "vo/core/error.h"
#include "vo/files/input.h"

namespace tools {

Printed run_and_read(const ChildCommand& command, const vo::WaitObserver& waiting) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "out").string();
  ChildCommand redirected = command;
  redirected.words = {"sh", "-c", "exec \"$@\" > \"$0\"", file};
  redirected.words.insert(redirected.words.end(), command.words.begin(), command.words.end());
  ChildEnd end = run_child(redirected, {}, waiting);
  constexpr int kEndedBySignal = 128;
  return {.exit_code = end.signal == 0 ? end.exit_code : kEndedBySignal + end.signal,
          .out = vo::read_file(file),
          .err = std::move(end.tail)};
}

bool is_in_path(const std::string& program) {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::string folder(rest.substr(0, rest.find(':')));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    if (::access(vo::concat(folder, "/", program).c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

}  // namespace tools
