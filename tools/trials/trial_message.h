#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tools/laboratory/results.h"
#include "tools/processes/forked_jobs.h"

namespace tools {

/// Returns all of a trial, its report included.
nlohmann::ordered_json json_of_trial(const TrialResult& trial);

/// Returns the trial of `json_of_trial`. Throws vo::Error or nlohmann::json::exception.
TrialResult trial_of_json(const nlohmann::ordered_json& json);

/// Returns a trial as bytes for another process, its report included.
std::string trial_message(const TrialResult& trial);

/// Returns the trial of which a process has told before it ended, or one whose problem says how the
/// process ended without a word.
TrialResult trial_of_process(const JobEnd& end, int seed);

}  // namespace tools
