#pragma once

#include <string>

#include "tools/cli/options.h"
#include "tools/studies/study.h"

namespace tools {

/// Writes a study's files into a folder and prints its table, or with --json its JSON. `command` is
/// what repeats it.
void deliver_study(const StudyReport& report, const std::string& command, const std::string& folder,
                   const CommonOptions& common);

}  // namespace tools
