#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/exit_code.h"
#include "tools/colour/colour.h"

namespace tools {

/// One run of the program: how its streams take colours, and how it ends.
struct Session {
  Colours out;                  ///< of stdout
  Colours err;                  ///< of stderr
  int status = exit_code::kOk;  ///< exit code
};

/// Returns the session of a command line, whose `--color` counts wherever it stands, also where the
/// rest of the line cannot be used; a value that is no ColourChoice is left to the parser.
Session start_session(const std::vector<std::string>& words);

/// Adds `--color` to a program and to all its commands. `start_session` has what it says.
void add_colour_option(CLI::App& program);

/// Returns the message of the parser of the command line with its first line in the tone of errors,
/// and control characters, as of a file's name, as `\x1B`.
std::string error_text(const Colours& colours, const std::string& message);

/// Returns an error as stderr has it, with its newline: `edvo: TEXT`, the program in its tone,
/// and control characters as `\x1B`.
std::string error_line(const Colours& colours, const std::string& text);

}  // namespace tools
