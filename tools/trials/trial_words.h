#pragma once

#include <string>

#include "tools/laboratory/results.h"
#include "tools/trials/test_run.h"

namespace tools {

/// Returns a trial's scenario and, unless it is 0, its seed.
std::string trial_name(const TrialJob& job);

/// Returns a trial's verdict in a word: by its scenario's own bounds, where those judge.
std::string trial_word(const TrialJob& job, const TrialResult& trial, const RunSettings& settings);

/// Returns the figures of a trial that say most, or its problem.
std::string trial_figures(const TrialResult& trial);

/// Returns how many scenarios have passed, of how many.
std::string passed_scenarios(const TestResults& results);

}  // namespace tools
