#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "tools/laboratory/results.h"

namespace tools {

/// Returns the results as JSON with `"schema": "edvo.results"` and its version; a baseline is such
/// a file. It has neither times nor paths, so that equal runs give equal bytes.
nlohmann::ordered_json results_json(const TestResults& results);

/// Reads results. Throws vo::Error naming the file when it is invalid or of another version.
TestResults read_results(const std::filesystem::path& file);

nlohmann::ordered_json trial_json(const TrialResult& trial);

/// Parses a trial; absent metrics are NaN. Throws vo::Error or nlohmann::json::exception.
TrialResult trial_from_json(const nlohmann::ordered_json& json);

}  // namespace tools
