#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/options.h"
#include "tools/laboratory/test_run.h"

namespace tools {

/// What the commands that measure scenarios for a study have in common.
struct LaboratoryArguments {
  CommonOptions common;
  std::string cache;
  std::vector<std::string> assignments;  ///< key=value, changes of the scenario
  std::string out;
  RunSettings run;

  Assignments changes() const;
  void complete();  ///< checks, and finds the cache
};

void add_laboratory_options(CLI::App& command, LaboratoryArguments& arguments);

}  // namespace tools
