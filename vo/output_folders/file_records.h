#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "vo/files/output.h"

namespace vo {

/// The file in every folder that is written, which lists what was written into it: a line
/// `hash bytes name` for each file (ContentHash), `- - name` for one that is planned. Nothing else
/// in the folder is ever removed.
inline constexpr const char* kFileList = ".edvo-files";

/// What is known of a file that was written; without a hash it is only planned.
struct FileRecord {
  std::string hash;
  std::uintmax_t size = 0;  ///< bytes
};

/// Records by the name of the file within its folder.
using FileRecords = std::map<std::string, FileRecord>;

FileRecord record_of(std::string_view bytes);

std::string format_records(const FileRecords& records);

/// Returns the records of a text; a line that is none, as in a text cut short, is left out.
FileRecords parse_records(std::string_view text);

/// Returns the records of a folder's list; none where there is no list.
FileRecords read_list(const std::filesystem::path& folder);

/// Returns whether a folder has a file of the recorded size.
bool has_size(const std::filesystem::path& folder, const std::string& name,
              const FileRecord& record);

/// Returns whether a folder has a file of the recorded bytes.
bool is_intact(const std::filesystem::path& folder, const std::string& name,
               const FileRecord& record);

/// Returns the names of all files below a folder, sorted; what is no folder is a file.
std::vector<std::string> files_below(const std::filesystem::path& folder);

/// Throws Error unless a folder may be put at `path`: nothing is there, or an empty folder, or
/// (with `replace`) one with nothing but files of its list. What somebody else put there is never
/// removed.
void require_replaceable(const std::filesystem::path& path, ExistingOutput existing);

}  // namespace vo
