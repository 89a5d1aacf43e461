#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/studies/study.h"
#include "tools/trials/test_run.h"

namespace tools {

/// A scenario option's key and the values to try.
using SweptOption = std::pair<std::string, std::vector<std::string>>;

struct SweepSettings {
  RunSettings run;
  std::vector<SweptOption> options;  ///< options whose values are combined in every way
};

/// Returns every scenario with every combination of values; those of the last option change
/// fastest. Throws vo::Error when an option, a value or a scene does not exist.
std::vector<LoadedScenario> swept_scenarios(const std::vector<std::filesystem::path>& files,
                                            const std::vector<SweptOption>& options);

/// Returns a row for each of the `swept_scenarios` with the means over the seeds and half the 95 %
/// confidence interval. `trials` are those of all seeds of each, in order; a failed one becomes a
/// row without numbers and a finding. Throws vo::Error of kind temporary where one may succeed
/// later, so that no table is kept that lacks it.
StudyReport sweep_report(const std::vector<LoadedScenario>& scenarios,
                         const std::vector<TrialResult>& trials, const SweepSettings& settings);

}  // namespace tools
