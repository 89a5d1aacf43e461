#include "tools/datasets/merging/merge.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

#include <tbb/parallel_for.h>

#include "tools/datasets/merging/card.h"
#include "tools/datasets/merging/dataset_index.h"
#include "tools/datasets/merging/part_damage.h"
#include "tools/datasets/merging/verify.h"
#include "tools/datasets/part_folder.h"
#include "tools/datasets/part_record.h"
#include "tools/datasets/parts/frame_rows.h"
#include "tools/datasets/plan_file.h"
#include "tools/datasets/sha256.h"
#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/files/result_files.h"
#include "vo/output_folders/file_records.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPlanCopy = "dataset.json";  // in the data set, by which it is recognised

/// Returns whether edvo gave something that lies in the folder of an unfinished data set its name.
bool is_own_name(const DatasetLayout& layout, const std::string& name) {
  return name == layout.plan().filename() || name == layout.parts().filename() ||
         name == layout.merged().filename() ||
         name.starts_with(PartFolder::partial_prefix(layout.index())) || vo::is_partial_name(name);
}

/// Returns the names of what lies in the folder of an unfinished data set and is not edvo's.
std::vector<std::string> foreign_names(const DatasetLayout& layout) {
  std::vector<std::string> names;
  for (const vo::FolderEntry& entry : vo::entries_of(layout.staging)) {
    if (!is_own_name(layout, entry.name)) {
      names.push_back(entry.name);
    }
  }
  return names;
}

/// Removes what edvo put into the folder of an unfinished data set, the plan last, by which the
/// folder is known until then.
void remove_own_entries(const DatasetLayout& layout) {
  for (const vo::FolderEntry& entry : vo::entries_of(layout.staging)) {
    if (is_own_name(layout, entry.name) && entry.name != layout.plan().filename()) {
      vo::remove_tree(layout.staging / entry.name);
    }
  }
  vo::remove_tree(layout.plan());
}

/// Removes what a data set was made in, and returns the names of what is not edvo's in it, which
/// stays in its folder. A folder that is edvo's alone gets a name first that nobody else's has,
/// under which one that a killed process left is removed, too.
std::vector<std::string> remove_staging(const DatasetLayout& layout) {
  const fs::path doomed = vo::partial_name(layout.out);
  vo::remove_tree(doomed);
  if (!fs::exists(layout.plan())) {
    return {};
  }
  std::vector<std::string> foreign = foreign_names(layout);
  if (!foreign.empty()) {
    remove_own_entries(layout);
    return foreign;
  }
  vo::rename_entry(layout.staging, doomed);
  vo::remove_tree(doomed);
  return {};
}

/// A data set while it is merged: files move from the parts' folders into one.
class Merge {
 public:
  Merge(const DatasetSpec& spec, const DatasetPlan& plan, const DatasetLayout& layout,
        vo::Durability durability)
      : spec_(spec),
        plan_(plan),
        layout_(layout),
        durability_(durability),
        plan_hash_(plan_hash(spec, plan)) {}

  /// Verifies all parts. One that is not as it was made is removed, and missing.
  void verify(const vo::Progress& progress, MergeOutcome& outcome) const {
    std::mutex mutex;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, plan_.parts.size(), [&](std::size_t part) {
      const std::string damage =
          damage_of_part({spec_, plan_, plan_hash_, part}, folder_of(part), target_of(part));
      const std::lock_guard lock(mutex);
      if (!damage.empty()) {
        outcome.damaged.push_back(part_name(spec_, plan_.parts[part]) + ": " + damage);
        outcome.missing.push_back(part);
        vo::remove_tree(folder_of(part));  // what a killed merge has moved of it is written over
      }
      ++done;
      if (progress) {
        progress(done, plan_.parts.size());
      }
    });
    std::sort(outcome.damaged.begin(), outcome.damaged.end());
    std::sort(outcome.missing.begin(), outcome.missing.end());
  }

  /// Moves the files of all parts and writes what describes them.
  void join(MergeOutcome& outcome) {
    vo::make_folder(layout_.merged());
    PartFolder index(layout_.index());
    index.write({{"frames.csv", frame_columns(spec_)}});
    for (std::size_t part = 0; part < plan_.parts.size(); ++part) {
      join_part(part, index, outcome);
    }
    describe(index, outcome);
    for (const std::string& file : vo::files_below(index.partial())) {
      if (durability_ == vo::Durability::synced) {
        vo::sync_to_disk(index.partial() / file);
      }
      vo::make_folder((layout_.merged() / file).parent_path());
      vo::rename_entry(index.partial() / file, layout_.merged() / file);
    }
  }

  /// Gives the data set its name. Files were synced when they were written, folders have changed
  /// since.
  void finish(MergeOutcome& outcome) const {
    if (durability_ == vo::Durability::synced) {
      for (const vo::FolderEntry& entry : vo::entries_below(layout_.merged())) {
        if (entry.kind == vo::EntryKind::folder) {
          vo::sync_to_disk(layout_.merged() / entry.name);
        }
      }
      vo::sync_to_disk(layout_.merged());
    }
    vo::rename_entry(layout_.merged(), layout_.out);
    if (durability_ == vo::Durability::synced) {
      vo::sync_to_disk(layout_.out.parent_path());
    }
    outcome.left = remove_staging(layout_);
  }

 private:
  fs::path folder_of(std::size_t part) const {
    return layout_.part(part, part_name(spec_, plan_.parts[part]));
  }

  fs::path target_of(std::size_t part) const {
    return layout_.merged() / scene_folder(spec_.sequences[plan_.parts[part].sequence]);
  }

  void join_part(std::size_t part, const PartFolder& index, MergeOutcome& outcome) {
    const PartRecord record = read_part_record(folder_of(part));
    const DatasetSequence& sequence = spec_.sequences[plan_.parts[part].sequence];
    std::string checksums;
    std::set<fs::path> made;  // folders that are there
    for (const MadeFile& file : record.files) {
      const fs::path from = folder_of(part) / file.name;
      const fs::path to = target_of(part) / file.name;
      if (made.insert(to.parent_path()).second) {
        vo::make_folder(to.parent_path());
      }
      if (path_exists(from)) {
        vo::rename_entry(from, to);
      }
      checksums += file.sha256 + "  " + scene_folder(sequence) + file.name + "\n";
      outcome.bytes += file.bytes;
    }
    outcome.files += record.files.size();
    const std::string rows = vo::read_file(folder_of(part) / kPartFrames);
    index_.add_rows(sequence, rows);
    index.append("frames.csv", rows);
    index.append(kChecksums, checksums);
    if (path_exists(folder_of(part) / kPartPicture)) {
      index.write(
          {{"pictures/" + sequence.name + ".webp", vo::read_file(folder_of(part) / kPartPicture)}});
    }
  }

  /// Writes the card, the index and the checksums of all that is not of a part.
  void describe(const PartFolder& index, MergeOutcome& outcome) const {
    index.write({{"README.md", dataset_card(spec_, plan_, index_)},
                 {"sequences.csv", index_.sequences_csv()},
                 {"statistics.svg", index_.plot()},
                 {"dataset.toml", vo::read_file(spec_.file)},
                 {kPlanCopy, format_plan(spec_, plan_)}});
    std::string checksums;
    for (const std::string& file : vo::files_below(index.partial())) {
      if (file != kChecksums) {
        checksums += sha256_of_file(index.partial() / file) + "  " + file + "\n";
        outcome.bytes += fs::file_size(index.partial() / file);
        ++outcome.files;
      }
    }
    index.append(kChecksums, checksums);
  }

  const DatasetSpec& spec_;
  const DatasetPlan& plan_;
  const DatasetLayout& layout_;
  vo::Durability durability_;
  std::string plan_hash_;
  DatasetIndex index_;
};

}  // namespace

std::vector<std::size_t> missing_parts(const DatasetSpec& spec, const DatasetPlan& plan,
                                       const DatasetLayout& layout) {
  std::vector<std::size_t> missing;
  for (std::size_t part = 0; part < plan.parts.size(); ++part) {
    if (!path_exists(layout.part(part, part_name(spec, plan.parts[part])) / kPartRecord)) {
      missing.push_back(part);
    }
  }
  return missing;
}

bool is_merged(const DatasetSpec& spec, const DatasetPlan& plan, const DatasetLayout& layout) {
  if (!path_exists(layout.out)) {
    return false;
  }
  const fs::path copy = layout.out / kPlanCopy;
  if (!path_exists(copy) || vo::read_file(copy) != format_plan(spec, plan)) {
    vo::fail_as(vo::ErrorKind::output_exists, layout.out.string(),
                ": is there and is not this data set; expected another --out, or it removed");
  }
  return true;
}

std::optional<vo::OutputLock> lock_merge(const DatasetLayout& layout,
                                         const vo::WaitObserver& waiting) {
  try {
    return vo::OutputLock(layout.out, vo::LockKind::exclusive, waiting);
  } catch (const vo::Error& error) {
    if (error.kind() != vo::ErrorKind::input) {
      throw;
    }
    return {};
  }
}

MergeOutcome merge_dataset(const DatasetSpec& spec, const DatasetPlan& plan,
                           const DatasetLayout& layout, vo::Durability durability,
                           const vo::Progress& progress) {
  if (is_merged(spec, plan, layout)) {
    return {.was_there = true, .left = remove_staging(layout)};
  }
  MergeOutcome outcome{.missing = missing_parts(spec, plan, layout)};
  Merge merge(spec, plan, layout, durability);
  if (outcome.missing.empty()) {
    merge.verify(progress, outcome);
  }
  if (outcome.missing.empty()) {
    merge.join(outcome);
    merge.finish(outcome);
  }
  return outcome;
}

}  // namespace tools
