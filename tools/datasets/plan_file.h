#pragma once

#include <filesystem>
#include <string>

#include "tools/datasets/plan.h"

namespace tools {

/// Returns a plan as JSON, for `read_plan` and for people.
std::string format_plan(const DatasetSpec& spec, const DatasetPlan& plan);

/// Returns the hash of a plan, by which a part says which data set it is of.
std::string plan_hash(const DatasetSpec& spec, const DatasetPlan& plan);

/// Reads what `format_plan` wrote. Throws vo::Error naming the file where it is none of that kind.
DatasetPlan read_plan(const std::filesystem::path& file);

}  // namespace tools
