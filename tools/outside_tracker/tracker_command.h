#pragma once

#include <filesystem>
#include <string>

#include "tools/processes/child_process.h"

namespace tools {

/// The places that an outside tracker is told of.
struct TrackerPlaces {
  std::filesystem::path sequence;  ///< folder of the sequence to track
  std::filesystem::path camera;    ///< its camera.toml
  std::filesystem::path output;    ///< trajectory to write
  std::filesystem::path scratch;   ///< folder to run in, and for temporary files
  std::filesystem::path withheld;  ///< folder that holds the truth; empty if none does
};

/// Throws vo::Error unless `command` is a program and its arguments, with {sequence} and {output}
/// among them or left to the environment, and no place within the script of a shell.
void validate_tracker_command(const std::string& command);

/// Returns the program to run: the words of the command with {sequence}, {camera} and {output}
/// replaced inside them. Words that name a file of the current folder become absolute. The
/// environment is this process' without the name of the withheld folder, with EDVO_SEQUENCE,
/// EDVO_CAMERA, EDVO_OUTPUT, TMPDIR, and OLDPWD for the current folder. Where permitted, the
/// program sees the sequence read-only and the withheld folder empty.
ChildCommand tracker_command(const std::string& command, const TrackerPlaces& places);

}  // namespace tools
