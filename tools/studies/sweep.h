#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/laboratory/test_run.h"
#include "tools/studies/study.h"

namespace tools {

/// An option of a scenario and the values that it takes.
using SweptOption = std::pair<std::string, std::vector<std::string>>;

struct SweepSettings {
  RunSettings run;
  std::vector<SweptOption> options;  ///< every combination of their values is measured
};

/// A row per scenario and combination of values: means over the seeds with half the 95 % confidence
/// interval. Throws vo::Error when an option or a value of it does not exist; what cannot be
/// measured is a row without figures and a finding.
StudyReport sweep(const std::vector<std::filesystem::path>& scenarios,
                  const SweepSettings& settings, const vo::Progress& progress,
                  const WaitObserver& waiting);

}  // namespace tools
