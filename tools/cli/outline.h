#pragma once

#include <CLI/CLI.hpp>

#include "tools/manual/command_outline.h"

namespace tools {

/// Returns the commands and options of a program as its parser knows them.
CommandOutline outline_of(const CLI::App& program);

}  // namespace tools
