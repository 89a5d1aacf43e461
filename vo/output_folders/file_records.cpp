#include "vo/output_folders/file_records.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/hashing/content_hash.h"
#include "vo/output_folders/part_records.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPlanned = "- -";

/// Adds the record of a line; does nothing for a line that is none.
void add_line(std::string_view line, FileRecords& records) {
  const std::size_t first = line.find(' ');
  const std::size_t second = first == std::string_view::npos ? first : line.find(' ', first + 1);
  if (second == std::string_view::npos || second + 1 == line.size()) {
    return;
  }
  FileRecord record;
  if (line.substr(0, second) != kPlanned) {
    const std::string_view size = line.substr(first + 1, second - first - 1);
    const char* const end = size.data() + size.size();
    record.hash = line.substr(0, first);
    const auto [stop, error] = std::from_chars(size.data(), end, record.size);
    if (error != std::errc() || stop != end || record.hash.size() != content_hash("").size()) {
      return;
    }
  }
  records[std::string(line.substr(second + 1))] = record;
}

}  // namespace

FileRecord record_of(std::string_view bytes) {
  return {content_hash(bytes), bytes.size()};
}

std::string format_records(const FileRecords& records) {
  std::string text;
  for (const auto& [name, record] : records) {
    text += (record.hash.empty() ? kPlanned : concat(record.hash, " ", record.size)) + " " + name +
            "\n";
  }
  return text;
}

FileRecords parse_records(std::string_view text) {
  FileRecords records;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    add_line(text.substr(0, end), records);
    text.remove_prefix(end + 1);
  }
  return records;
}

FileRecords read_list(const fs::path& folder) {
  const fs::path file = folder / kFileList;
  return fs::is_regular_file(file) ? parse_records(read_file(file)) : FileRecords();
}

bool has_size(const fs::path& folder, const std::string& name, const FileRecord& record) {
  std::error_code error;
  return !record.hash.empty() && fs::is_regular_file(folder / name, error) &&
         fs::file_size(folder / name, error) == record.size && !error;
}

bool is_intact(const fs::path& folder, const std::string& name, const FileRecord& record) {
  return has_size(folder, name, record) && content_hash(read_file(folder / name)) == record.hash;
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (FolderEntry& entry : entries_below(folder)) {
    if (entry.kind != EntryKind::folder) {
      files.push_back(std::move(entry.name));
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void require_replaceable(const fs::path& path, ExistingOutput existing) {
  if (!fs::exists(path)) {
    return;
  }
  require(fs::is_directory(path), path.string(), ": is a file, expected a folder to write");
  if (fs::is_empty(path)) {
    return;
  }
  if (existing == ExistingOutput::keep) {
    fail_to_replace(path);
  }
  require(fs::is_regular_file(path / kFileList), path.string(),
          ": holds other files than edvo's (no ", kFileList, "), so it is not replaced");
  const FileRecords records = read_list(path);
  for (const std::string& name : files_below(path)) {
    require(records.contains(name) || name == kFileList || is_partial_name(name) ||
                is_part_record(name),
            path.string(), ": holds ", name, ", which edvo did not write (", kFileList,
            " lists what it wrote), so it is not replaced; move that file elsewhere");
  }
}

}  // namespace vo
