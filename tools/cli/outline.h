#pragma once

#include <vector>

#include <CLI/CLI.hpp>

#include "tools/manual/command_outline.h"

namespace tools {

/// Returns the commands of a program, or of a command that has parts.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// Returns the commands and options of a program as its parser knows them.
CommandOutline outline_of(const CLI::App& program);

}  // namespace tools
