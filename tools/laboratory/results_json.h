#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "tools/laboratory/results.h"

namespace tools {

/// Results as JSON: `"schema": "edvo.results"` and its version. A baseline is the same file. No
/// times, no places: equal runs give equal bytes.
nlohmann::ordered_json results_json(const TestResults& results);

/// Throws vo::Error naming the file when it is no such JSON or of another version.
TestResults read_results(const std::filesystem::path& file);

nlohmann::ordered_json trial_json(const TrialResult& trial);

/// Throws vo::Error or nlohmann::json::exception. Metrics that are absent are NaN.
TrialResult trial_from_json(const nlohmann::json& json);

}  // namespace tools
