#pragma once

#include <string>

#include "tools/datasets/merging/dataset_index.h"
#include "tools/datasets/plan.h"
#include "tools/datasets/spec.h"

namespace tools {

/// Returns README.md of a data set: what it holds, statistics, sample pictures, how its files are
/// to be read, what was rejected, and the command that makes it again.
std::string dataset_card(const DatasetSpec& spec, const DatasetPlan& plan,
                         const DatasetIndex& index);

}  // namespace tools
