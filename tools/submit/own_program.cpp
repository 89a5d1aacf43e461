#include "tools/submit/own_program.h"

#include <algorithm>
#include <string_view>

#include "tools/cli/exit_code.h"
#include "tools/submit/shared_work.h"
#include "vo/core/error.h"

namespace tools {
namespace {

vo::ErrorKind kind_of(int exit_code) {
  for (const vo::ErrorKind kind : {vo::ErrorKind::usage, vo::ErrorKind::output_exists,
                                   vo::ErrorKind::temporary, vo::ErrorKind::interrupted}) {
    if (exit_code::of(kind) == exit_code) {
      return kind;
    }
  }
  return vo::ErrorKind::input;
}

/// Returns the last line of what a command of edvo said, without the program's name.
std::string message_of(const Printed& printed, const std::vector<std::string>& words) {
  constexpr std::string_view kName = "edvo: ";
  std::string text = printed.err.substr(0, printed.err.find_last_not_of('\n') + 1);
  text.erase(0, text.rfind('\n') + 1);
  if (text.starts_with(kName)) {
    text.erase(0, kName.size());
  }
  return text.empty() ? vo::concat(shell_line(words), ": exit code ", printed.exit_code) : text;
}

}  // namespace

std::filesystem::path own_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

Printed ask_program(const ChildCommand& command, std::initializer_list<int> answers,
                    const vo::WaitObserver& waiting) {
  Printed printed = run_and_read(command, waiting);
  if (std::find(answers.begin(), answers.end(), printed.exit_code) == answers.end()) {
    vo::fail_as(kind_of(printed.exit_code), message_of(printed, command.words));
  }
  return printed;
}

nlohmann::json printed_member(const Printed& printed, const std::string& name) {
  try {
    return nlohmann::json::parse(printed.out).at(name);
  } catch (const nlohmann::json::exception& error) {
    vo::fail("edvo itself: printed a document without ", name, ": ", error.what());
  }
}

}  // namespace tools
