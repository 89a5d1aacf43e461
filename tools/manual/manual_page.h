#pragma once

#include <string>

#include "tools/manual/command_outline.h"

namespace tools {

/// A ManualEdition is what every manual page of one release of the program has in common.
struct ManualEdition {
  std::string version;     ///< `0.2.0`
  std::string exit_codes;  ///< what each means, as the program's help ends
};

/// Returns the manual page, section 1, of the program: all its commands. man reads it.
std::string manual_page(const CommandOutline& program, const ManualEdition& edition);

/// Returns the manual page, section 1, of one of the program's commands.
std::string manual_page(const CommandOutline& program, const CommandOutline& command,
                        const ManualEdition& edition);

/// Returns the reference of all commands and their options as Markdown.
std::string markdown_reference(const CommandOutline& program);

}  // namespace tools
