#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/datasets/plan.h"
#include "tools/datasets/spec.h"

namespace tools {

/// A part as the plan of a data set has it.
struct PlannedPart {
  const DatasetSpec& spec;
  const DatasetPlan& plan;
  const std::string& plan_hash;
  std::size_t index = 0;  ///< of the part in the plan

  const DatasetPart& part() const { return plan.parts[index]; }
  const DatasetSequence& sequence() const { return spec.sequences[part().sequence]; }
};

/// Returns what is wrong with the part in a folder; empty where it is the one of the plan, with a
/// row for each of its frames, lists the files of each, and all files are as they were made. A file
/// may lie in `target` instead, where a merge that was killed has moved it.
std::string damage_of_part(const PlannedPart& planned, const std::filesystem::path& folder,
                           const std::filesystem::path& target);

}  // namespace tools
