#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/laboratory/results.h"
#include "tools/statistics/difference_test.h"

namespace tools {

/// The trials of a scenario that two results are compared by.
struct TrialPairs {
  std::vector<const TrialResult*> before;
  std::vector<const TrialResult*> after;
  bool paired = true;          ///< trials with equal index have equal seeds
  bool same_sequences = true;  ///< paired trials tracked identical sequences
};

/// Returns the trials whose seeds both results have, or all as independent samples if there are
/// none. Trials that repeat one, with an identical sequence and equal metrics, are left out: where
/// the random numbers change nothing, several seeds are one trial. The pointers are valid as long
/// as the results.
TrialPairs pair_trials(const ScenarioResult& before, const ScenarioResult& after);

/// Returns each metric's values, one per trial; NaN where it was not measured.
std::vector<std::pair<std::string, Samples>> samples_of(const TrialPairs& pairs);

/// Returns the finite values; of pairs only those with both values finite.
Samples measured(const Samples& samples);

}  // namespace tools
