#include "tools/datasets/merging/part_damage.h"

#include <set>
#include <vector>

#include "tools/datasets/layout.h"
#include "tools/datasets/merging/dataset_index.h"
#include "tools/datasets/merging/verify.h"
#include "tools/datasets/part_folder.h"
#include "tools/datasets/part_record.h"
#include "vo/core/error.h"
#include "vo/text_files/text_lines.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

// The columns of frames.csv that say what a part holds.
constexpr std::size_t kSequenceCell = 1;
constexpr std::size_t kFrameCell = 2;
constexpr std::size_t kArchiveCell = 4;
constexpr std::size_t kColourCell = 5;
constexpr std::size_t kDepthCell = 6;

/// Returns the names of the files that the index takes from a part.
std::vector<std::string> planned_index_files(const PlannedPart& planned) {
  const DatasetPart& part = planned.part();
  const std::size_t middle = planned.plan.frames[part.sequence] / 2;
  const bool has_picture = part.first <= middle && middle < part.end;
  return has_picture ? std::vector<std::string>{kPartFrames, kPartPicture}
                     : std::vector<std::string>{kPartFrames};
}

/// Throws vo::Error unless a record says that it is of the part, and names files of its sequence.
void require_record_of(const PlannedPart& planned, const PartRecord& record) {
  const std::string name = part_name(planned.spec, planned.part());
  vo::require(record.part == name, kPartRecord, ": is of part ", record.part, ", expected ", name);
  vo::require(record.plan == planned.plan_hash, kPartRecord, ": is of another data set");
  std::vector<std::string> names;
  for (const MadeFile& file : record.index_files) {
    names.push_back(file.name);
  }
  vo::require(names == planned_index_files(planned), kPartRecord, ": index_files: expected ",
              kPartFrames, " and, of the middle frame, ", kPartPicture);
  const std::string& sequence = planned.sequence().name;
  for (const MadeFile& file : record.files) {
    vo::require(file.name.starts_with(sequence + "/") || file.name.starts_with(sequence + "."),
                kPartRecord, ": files: ", file.name, " is no file of ", sequence);
  }
}

/// Throws vo::Error unless a part has a row for each of its frames, and lists the files of each.
void require_frames_of(const PlannedPart& planned, const PartRecord& record,
                       const fs::path& folder) {
  std::set<std::string> made;  // by their paths in the data set
  for (const MadeFile& file : record.files) {
    made.insert(scene_folder(planned.sequence()) + file.name);
  }
  const auto require_made = [&](const std::string& file) {
    vo::require(made.contains(file), kPartRecord, ": files: expected ", file);
  };
  std::size_t rows = 0;
  const vo::TextFile file(folder / kPartFrames);
  file.for_each_whole_line([&](const vo::TextLine& line) {
    const std::vector<std::string> cells = cells_of_row(line.text);
    const std::size_t frame = planned.part().first + rows++ / planned.plan.cameras;
    vo::require(cells[kSequenceCell] == planned.sequence().name &&
                    cells[kFrameCell] == std::to_string(frame),
                line.place(), ": expected frame ", frame, " of ", planned.sequence().name);
    if (!cells[kArchiveCell].empty()) {
      require_made(cells[kArchiveCell]);
    } else {
      require_made(cells[kColourCell]);
      require_made(cells[kDepthCell]);
    }
  });
  const std::size_t expected = planned.plan.cameras * planned.part().frame_count();
  vo::require(rows == expected, kPartFrames, ": ", rows, " rows, expected ", expected);
}

void require_as_made(const fs::path& folder, const MadeFile& file) {
  const std::string damage = damage_of_file(folder / file.name, file.sha256);
  vo::require(damage.empty(), file.name, " ", damage);
}

void require_undamaged(const PlannedPart& planned, const fs::path& folder, const fs::path& target) {
  const PartRecord record = read_part_record(folder);
  require_record_of(planned, record);
  for (const MadeFile& file : record.index_files) {
    require_as_made(folder, file);
  }
  require_frames_of(planned, record, folder);
  for (const MadeFile& file : record.files) {
    const bool is_moved = !path_exists(folder / file.name) && path_exists(target / file.name);
    require_as_made(is_moved ? target : folder, file);
  }
}

}  // namespace

std::string damage_of_part(const PlannedPart& planned, const fs::path& folder,
                           const fs::path& target) {
  try {
    require_undamaged(planned, folder, target);
  } catch (const vo::Error& error) {
    if (error.kind() != vo::ErrorKind::input) {
      throw;
    }
    return error.what();
  }
  return {};
}

}  // namespace tools
