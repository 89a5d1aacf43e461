#pragma once

#include <cstddef>

#include "tools/datasets/plan.h"
#include "tools/datasets/sequence_jobs.h"
#include "tools/datasets/spec.h"
#include "vo/core/progress.h"

namespace tools {

/// What a data set will cost, as a few frames of a few of its sequences take.
struct DatasetEstimate {
  std::size_t files = 0;     ///< of the sequences
  double bytes = 0;          ///< of these files
  double processor_s = 0;    ///< s, processor time of all threads together, loading included
  std::size_t measured = 0;  ///< number of frames rendered for the estimate
};

/// Renders up to three frames of up to eight sequences, evenly spread, without writing.
DatasetEstimate estimate_dataset(const DatasetSpec& spec, const DatasetPlan& plan,
                                 const vo::Progress& progress);

}  // namespace tools
