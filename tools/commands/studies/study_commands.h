#pragma once

#include <string>
#include <vector>

#include "tools/cli/options.h"
#include "tools/studies/study.h"
#include "tools/trials/test_run.h"

namespace tools {

/// Options shared by the commands that measure scenarios for a study.
struct LaboratoryArguments {
  CommonOptions common;
  std::string cache;
  std::vector<std::string> assignments;  ///< changes of the scenario as key=value
  std::string out;
  RunSettings run;

  void complete();  ///< validates the options and sets the cache folder
};

void add_laboratory_options(CLI::App& command, LaboratoryArguments& arguments);

/// Writes a study's files into a folder and prints its table, or its JSON with --json. `command` is
/// the command that repeats the study.
void deliver_study(const StudyReport& report, const std::string& command, const std::string& folder,
                   const CommonOptions& common);

/// Prints a study's table, or its JSON with --json.
void print_study(const StudyReport& report, const CommonOptions& common);

}  // namespace tools
