#pragma once

#include <array>
#include <string>
#include <utility>

#include "tools/manual/command_outline.h"

namespace tools {

enum class Shell { bash, zsh, fish };

constexpr auto enum_names(Shell) {
  return std::array{std::pair{Shell::bash, "bash"}, std::pair{Shell::zsh, "zsh"},
                    std::pair{Shell::fish, "fish"}};
}

/// Returns the script by which a shell completes the program's commands and options, and files
/// elsewhere.
std::string completion_script(const CommandOutline& program, Shell shell);

}  // namespace tools
