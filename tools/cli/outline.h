#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/manual/command_outline.h"

namespace tools {

/// Returns the commands of a program, or of a command that has parts.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// Returns the option of a command by its name, `--json` or `FOLDER`; null where there is none.
/// CLI11's `get_option` and `get_option_no_throw` end the program where memory does.
template <typename App>
auto find_option(App& app, const std::string& name) {
  const auto options =
      app.get_options([&](const CLI::Option* option) { return option->check_name(name); });
  return options.empty() ? nullptr : options.front();
}

/// Returns the commands and options of a program as its parser knows them.
CommandOutline outline_of(const CLI::App& program);

}  // namespace tools
