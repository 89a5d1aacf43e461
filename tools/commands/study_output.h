#pragma once

#include <string>

#include "tools/cli/options.h"
#include "tools/studies/study.h"

namespace tools {

/// Writes a study's files into a folder and prints its table, or its JSON with --json. `command` is
/// the command that repeats the study.
void deliver_study(const StudyReport& report, const std::string& command, const std::string& folder,
                   const CommonOptions& common);

}  // namespace tools
