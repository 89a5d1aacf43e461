#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/datasets/layout.h"
#include "tools/datasets/plan.h"
#include "tools/datasets/plan_file.h"
#include "tools/datasets/sequence_jobs.h"
#include "tools/datasets/spec.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"

namespace tools {

/// Makes the parts of a data set, one after the other, the frames of each in parallel. What it is
/// given must outlive it.
class PartMaker {
 public:
  PartMaker(const DatasetSpec& spec, const DatasetPlan& plan, const DatasetLayout& layout,
            vo::Durability durability)
      : spec_(spec),
        plan_(plan),
        layout_(layout),
        durability_(durability),
        plan_hash_(plan_hash(spec, plan)),
        jobs_(spec) {}

  /// Returns whether a part is there.
  bool is_there(std::size_t part) const;

  /// Renders a part and gives it its name. `progress`, which must not be empty, counts the frames
  /// of all cameras. Throws vo::Error where the scene is unusable or the disk full; what was made
  /// of the part is gone then.
  void make(std::size_t part, const vo::Progress& progress);

 private:
  std::filesystem::path folder_of(std::size_t part) const;

  const DatasetSpec& spec_;
  const DatasetPlan& plan_;
  const DatasetLayout& layout_;
  vo::Durability durability_;
  std::string plan_hash_;
  SequenceJobs jobs_;
};

}  // namespace tools
