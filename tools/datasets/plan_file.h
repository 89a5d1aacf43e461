#pragma once

#include <filesystem>
#include <string>

#include "tools/datasets/plan.h"

namespace tools {

/// Returns a plan as JSON, as a data set that is complete has it.
std::string format_plan(const DatasetSpec& spec, const DatasetPlan& plan);

/// Returns a plan as JSON with its hash, for `read_plan`.
std::string format_sealed_plan(const DatasetSpec& spec, const DatasetPlan& plan);

/// Returns the hash of a plan, by which a part says which data set it is of.
std::string plan_hash(const DatasetSpec& spec, const DatasetPlan& plan);

/// Reads what `format_sealed_plan` wrote. Throws vo::Error naming the file where it is not as it
/// was written, of kind output_exists where it has no hash, as those of earlier versions.
DatasetPlan read_plan(const std::filesystem::path& file);

}  // namespace tools
