#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/datasets/plan.h"
#include "tools/datasets/spec.h"

namespace tools {

/// Where a data set is while it is made, and where it will be:
///     OUT.part/plan.json            what is made (`DatasetPlan`)
///     OUT.part/parts/000/NAME-000/  a part of a sequence, complete when the folder is there; a
///                                   thousand of them in one folder
///     OUT.part/dataset/             the data set while it is merged
///     OUT/                          the data set
struct DatasetLayout {
  explicit DatasetLayout(const std::filesystem::path& out);

  std::filesystem::path out;      ///< absolute
  std::filesystem::path staging;  ///< OUT.part

  std::filesystem::path plan() const { return staging / "plan.json"; }
  std::filesystem::path parts() const { return staging / "parts"; }
  std::filesystem::path part(std::size_t index, const std::string& name) const;
  std::filesystem::path index() const { return staging / "index"; }
  std::filesystem::path merged() const { return staging / "dataset"; }
};

/// The files of a part's folder that are no data: what was made and how long it took, and the
/// part's rows of frames.csv.
inline constexpr const char* kPartRecord = "part.json";
inline constexpr const char* kPartFrames = "frames.rows";
inline constexpr const char* kPartPicture = "picture.webp";  ///< in the part with the middle frame

/// Returns the name of a part: its sequence's and the number of the part in it, from 0.
std::string part_name(const DatasetSpec& spec, const DatasetPart& part);

/// Returns the folder that a scene's sequences are in, within the data set: SPLIT/SCENE/, with the
/// slash.
std::string scene_folder(const DatasetSequence& sequence);

}  // namespace tools
