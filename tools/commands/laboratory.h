#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/options.h"
#include "tools/laboratory/test_run.h"

namespace tools {

/// Options shared by the commands that measure scenarios for a study.
struct LaboratoryArguments {
  CommonOptions common;
  std::string cache;
  std::vector<std::string> assignments;  ///< changes of the scenario as key=value
  std::string out;
  RunSettings run;

  Assignments changes() const;
  void complete();  ///< validates the options and sets the cache folder
};

void add_laboratory_options(CLI::App& command, LaboratoryArguments& arguments);

}  // namespace tools
