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

/// Measures every scenario with every combination of values: a row each with the means over the
/// seeds and half the 95 % confidence interval. Throws vo::Error when an option or a value does not
/// exist; a failed trial becomes a row without numbers and a finding.
StudyReport sweep(const std::vector<std::filesystem::path>& scenarios,
                  const SweepSettings& settings, const vo::Progress& progress,
                  const vo::WaitObserver& waiting);

}  // namespace tools
