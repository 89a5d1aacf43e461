#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tools {

/// A file of a part as it was made.
struct MadeFile {
  std::string name;  ///< path within the folder SPLIT/SCENE, and within the part
  std::uintmax_t bytes = 0;
  std::string sha256;
};

/// What a task says of a part that it has made: part.json in the part's folder.
struct PartRecord {
  std::string part;
  std::string plan;        ///< hash of the data set's plan
  std::string host;        ///< machine that made it
  double processor_s = 0;  ///< processor time of all threads
  std::vector<MadeFile> files;
  std::vector<MadeFile> index_files{};  ///< what the data set's index and card are made of
};

/// Returns a record as JSON, with a hash of it.
std::string format_part_record(const PartRecord& record);

/// Reads part.json of a part's folder. Throws vo::Error naming the file where it is none, is not
/// as it was written, or names a file that lies elsewhere than in the folder.
PartRecord read_part_record(const std::filesystem::path& part_folder);

}  // namespace tools
