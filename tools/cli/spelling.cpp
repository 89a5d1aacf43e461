#include "tools/cli/spelling.h"

#include <algorithm>

#include "tools/cli/outline.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

/// Returns the command of this name; null where there is none.
const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  const std::vector<const CLI::App*> commands = commands_of(app);
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const CLI::App* c) { return c->get_name() == name; });
  return found == commands.end() ? nullptr : *found;
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

[[noreturn]] void reject(const std::string& what, const std::string& word,
                         const std::vector<std::string>& known, const std::string& help) {
  const std::string nearest = vo::nearest_key(word, known);
  vo::fail_as(vo::ErrorKind::usage, "there is no ", what, " ", word,
              nearest.empty() ? "" : "; the nearest is " + nearest, " (", help, " lists all)");
}

}  // namespace

void require_known_words(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* app = &program;
  std::string help = program.get_name() + " --help";
  for (const std::string& word : words) {
    if (word == "--") {
      return;
    }
    const bool is_option = word.size() > 2 && word.compare(0, 2, "--") == 0;
    const std::vector<const CLI::App*> commands = commands_of(*app);
    if (is_option) {
      const std::string name = word.substr(0, word.find('='));
      if (find_option(*app, name) == nullptr) {
        reject("option", name, options_of(*app), help);
      }
    } else if (!commands.empty() && word.front() != '-') {
      const CLI::App* command = find_command(*app, word);
      if (command == nullptr) {
        reject("command", word, names_of(commands), help);
      }
      app = command;
      help = program.get_name() + " " + word + " --help";
    }
  }
}

std::vector<std::string> without_json_place(const CLI::App& program,
                                            std::vector<std::string> words) {
  const CLI::App* app = &program;
  for (std::size_t i = 0; i + 1 < words.size() && words[i] != "--"; ++i) {
    const CLI::App* command = find_command(*app, words[i]);
    app = command != nullptr ? command : app;
    const CLI::Option* json = words[i] == "--json" ? find_option(*app, "--json") : nullptr;
    const bool is_flag = json != nullptr && json->get_items_expected_max() == 0;
    if (is_flag && words[i + 1] == "-") {
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
  }
  return words;
}

std::vector<std::string> without_help_command(std::vector<std::string> words) {
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

}  // namespace tools
