#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/core/fields.h"

namespace tools {

/// Metrics, bounds and verdict as JSON. No times, no places: equal runs give equal bytes.
nlohmann::ordered_json report_json(const Scenario& scenario, const Outcome& outcome);

/// The same for people, with the pictures beside it and the command that repeats the run.
std::string report_markdown(const Scenario& scenario, const Outcome& outcome);

/// The aligned table that `edvo run` prints: metric, measured, bound, verdict; one verdict line.
std::string report_table(const Scenario& scenario, const Outcome& outcome);

std::string shown_number(double value);  ///< six digits

std::string bound_text(const Bound& bound);  ///< ">= 0.9, <= 1"

/// An options struct's fields as a JSON object by dotted key.
nlohmann::ordered_json fields_json(const std::vector<vo::Field>& fields);

nlohmann::ordered_json time_json(const vo::TimeSummary& times);

}  // namespace tools
