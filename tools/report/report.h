#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/colour/colour.h"
#include "tools/scenario/run_scenario.h"
#include "tools/scenario/scenario.h"
#include "vo/core/fields.h"

namespace tools {

/// Returns metrics, bounds and verdict as JSON, without times and paths, which may differ.
nlohmann::ordered_json report_json(const Scenario& scenario, const Outcome& outcome);

/// Returns a Markdown report with the trajectory and the command that repeats the run.
std::string report_markdown(const Scenario& scenario, const Outcome& outcome);

/// Returns the table that `edvo run` prints: metric, measured value, bound; then the verdict.
std::string report_table(const Scenario& scenario, const Outcome& outcome,
                         const Colours& colours = {});

std::string shown_number(double value);  ///< the value with six significant digits

std::string bound_text(const Bound& bound);  ///< a text such as ">= 0.9, <= 1"

/// Returns the fields of an options struct as a JSON object by dotted key.
nlohmann::ordered_json fields_json(const std::vector<vo::Field>& fields);

nlohmann::ordered_json time_json(const vo::TimeSummary& times);

}  // namespace tools
