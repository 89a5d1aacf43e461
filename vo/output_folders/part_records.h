#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/output_folders/file_records.h"

namespace vo {

/// Returns the name of the record of a part within a folder that is filled in parts.
std::string part_record_name(const std::string& part);

/// Returns whether a name within a folder is one that `part_record_name` gives.
bool is_part_record(const std::string& name);

/// What is finished in a folder that is filled in parts, each of several files: those that its list
/// or the part's own record has with size and hash.
class PartRecords {
 public:
  /// Reads the folder's list; the records of parts are read when they are asked for.
  explicit PartRecords(std::filesystem::path folder);

  /// Returns whether the folder has all files of a part with the recorded sizes.
  bool has(const std::string& part, const std::vector<std::string>& files) const;

  /// Returns the records of a part's files, without those that have none.
  FileRecords of(const std::string& part, const std::vector<std::string>& files) const;

 private:
  std::filesystem::path folder_;
  FileRecords listed_;
};

}  // namespace vo
