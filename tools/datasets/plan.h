#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/datasets/spec.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"

namespace tools {

/// Consecutive frames of one sequence that one task makes and moves together, of every camera.
struct DatasetPart {
  std::size_t sequence = 0;  ///< index in the spec's sequences
  std::size_t number = 0;    ///< of the part in its sequence, from 0
  std::size_t first = 0;     ///< first frame
  std::size_t end = 0;       ///< one past the last frame

  std::size_t frame_count() const { return end - first; }  ///< of a camera

  bool operator==(const DatasetPart&) const = default;
};

/// A sequence that is not made, and why.
struct RejectedSequence {
  std::string name;
  std::string reason;
};

/// What a data set is made of: a pure function of the spec, the files that it names and the program
/// that renders.
struct DatasetPlan {
  std::map<std::string, std::string> identity;  ///< what determines the bytes, by key
  std::size_t cameras = 1;                      ///< number of cameras that take each sequence
  std::vector<std::size_t> frames;  ///< of a camera, by sequence of the spec; 0 where rejected
  std::vector<RejectedSequence> rejected;  ///< in the order of the sequences
  std::vector<DatasetPart> parts;          ///< by sequence and frame

  std::size_t frame_count() const;     ///< number of frames of all cameras
  std::size_t sequence_count() const;  ///< number of sequences that are made
};

/// Plans a data set: the frames of every sequence, those that the filter rejects or whose path
/// cannot be made left out. Each path is planned and, where there is a filter, checked; `progress`
/// counts sequences. Throws vo::Error for a scene that cannot be used, for a scene or camera that
/// the chosen renderer cannot draw, and for a data set of more parts or frames than folders should
/// hold.
DatasetPlan make_plan(const DatasetSpec& spec, const vo::Progress& progress);

/// Throws vo::Error naming the file that a plan was read from unless its cameras, sequences and
/// parts are those that the spec has with these numbers of frames.
void require_plan_of(const DatasetSpec& spec, const DatasetPlan& plan,
                     const std::filesystem::path& plan_file);

/// Returns the plan that `staging`/plan.json keeps, or makes it and keeps it there; any number of
/// tasks may do so at once. Throws vo::Error of kind output_exists, naming the keys, where what is
/// there was begun with another spec, other scenes or another program, and one of kind input where
/// it was edited.
DatasetPlan begin_dataset(const DatasetSpec& spec, const std::filesystem::path& plan_file,
                          vo::Durability durability, const vo::Progress& progress);

/// Returns the share, 1 to `shares`, that each part belongs to. Shares are consecutive, and their
/// numbers of frames differ as little as whole parts allow.
std::vector<std::size_t> shares_by_part(const DatasetPlan& plan, std::size_t shares);

/// Returns the parts of the K-th of N shares, K from 1.
std::vector<std::size_t> share_of_parts(const DatasetPlan& plan, std::size_t k, std::size_t n);

/// Returns the shares, of so many, that some parts belong to, ascending; `parts` ascend, too.
std::vector<std::size_t> shares_with(const DatasetPlan& plan, const std::vector<std::size_t>& parts,
                                     std::size_t shares);

}  // namespace tools
