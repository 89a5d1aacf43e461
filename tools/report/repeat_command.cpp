#include "tools/report/repeat_command.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

#include "tools/processes/shell_words.h"
#include "vo/files/input.h"

namespace tools {
namespace {

/// Returns the text as one word of a shell, quoted only where it must be.
std::string shell_word(const std::string& text) {
  const bool is_plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_-./+:,=@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return is_plain ? text : shell_quoted(text);
}

/// Returns the arguments that name the file, also if its name begins like an option; - for stdin.
std::string file_word(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (file == vo::kStdinPath) {
    return "-";
  }
  return shell_word(name.starts_with('-') ? "./" + name : name);
}

RepeatCommand here(std::string command) {
  return {.folder = std::filesystem::current_path().string(), .command = std::move(command)};
}

}  // namespace

RepeatCommand repeat_run(const Scenario& scenario) {
  return here("edvo run " + file_word(scenario.file) + " --out " +
              file_word(scenario.name + "_again"));
}

RepeatCommand repeat_test(const Scenario& scenario, const std::string& tracker) {
  return here("edvo test " + file_word(scenario.file) + " --bounds none --tracker " +
              shell_word(tracker) + " --report " + file_word(scenario.name + "_again.html"));
}

}  // namespace tools
