#pragma once

#include <string>

#include "tools/scenario/scenario.h"

namespace tools {

/// A command that repeats a run when it is pasted into a shell in `folder`.
struct RepeatCommand {
  std::string folder;  ///< absolute, the folder that the run was started in
  std::string command;
};

/// Returns the command that runs a scenario with edvo's own tracker and reports on it.
RepeatCommand repeat_run(const Scenario& scenario);

/// Returns the command that measures an outside tracker, given as to `edvo test --tracker`, on a
/// scenario and reports on it.
RepeatCommand repeat_test(const Scenario& scenario, const std::string& tracker);

}  // namespace tools
