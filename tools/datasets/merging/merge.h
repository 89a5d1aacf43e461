#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/datasets/layout.h"
#include "tools/datasets/plan.h"
#include "tools/datasets/spec.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"
#include "vo/files/output_lock.h"

namespace tools {

struct MergeOutcome {
  bool was_there = false;            ///< it had been merged before
  std::vector<std::size_t> missing;  ///< parts that are not there, damaged ones among them
  std::vector<std::string> damaged;  ///< a sentence for each part that was removed for damage
  std::vector<std::string> left;     ///< names in OUT.part that are not edvo's, and stay there
  std::size_t files = 0;             ///< number of files with a checksum
  std::uintmax_t bytes = 0;          ///< of these files
};

/// Returns the parts that are not there.
std::vector<std::size_t> missing_parts(const DatasetSpec& spec, const DatasetPlan& plan,
                                       const DatasetLayout& layout);

/// Returns whether the data set is there, complete. Throws vo::Error of kind output_exists where
/// something else is in its place.
bool is_merged(const DatasetSpec& spec, const DatasetPlan& plan, const DatasetLayout& layout);

/// Waits until no other process merges the data set, and keeps others from it; returns nothing
/// where the file system has no locks. `waiting` is called meanwhile.
std::optional<vo::OutputLock> lock_merge(const DatasetLayout& layout,
                                         const vo::WaitObserver& waiting);

/// Makes the data set of its parts, which are verified, moved and described; the folder appears
/// when it is complete. A part that is not as it was made is removed and is missing then. With a
/// missing part nothing is merged. A merge that was killed goes on; one that was killed after its
/// last file leaves only what is to be removed. Memory does not grow with the number of frames.
/// Throws vo::Error of kind output_exists where something else is in the data set's place.
MergeOutcome merge_dataset(const DatasetSpec& spec, const DatasetPlan& plan,
                           const DatasetLayout& layout, vo::Durability durability,
                           const vo::Progress& progress);

}  // namespace tools
