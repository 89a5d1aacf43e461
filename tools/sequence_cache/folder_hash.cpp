#include "tools/sequence_cache/folder_hash.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/hashing/content_hash.h"
#include "vo/output_folders/file_records.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

std::string line_of(const fs::path& folder, const std::string& name) {
  const std::string bytes = vo::read_file(folder / name);
  return vo::concat(vo::content_hash(bytes), " ", bytes.size(), " ", name);
}

std::string name_in(std::string_view line) {
  const std::size_t first = line.find(' ');
  const std::size_t second = first == std::string_view::npos ? first : line.find(' ', first + 1);
  return second == std::string_view::npos ? "" : std::string(line.substr(second + 1));
}

/// Returns whether a line has a hash as ContentHash writes it, and not the shorter one of before.
bool is_of_this_kind(const std::string& line) {
  return line.find(' ') == vo::content_hash("").size();
}

std::vector<std::string> file_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : vo::entries_below(folder)) {
    if (kind != vo::EntryKind::folder && name != vo::kFileList) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::string list_file_hashes(const fs::path& folder) {
  std::string text;
  for (const std::string& name : file_names(folder)) {
    text += line_of(folder, name) + "\n";
  }
  return text;
}

std::string find_difference(const fs::path& folder, const std::string& listed) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return "the folder is missing";
  }
  std::istringstream lines(listed);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const std::string name = name_in(line);
    if (!is_of_this_kind(line)) {
      return "its list of files is an earlier edvo's";
    }
    if (name.empty() || !fs::is_regular_file(folder / name, error)) {
      return name + " is missing";
    }
    if (line_of(folder, name) != line) {
      return name + " has other bytes than were written";
    }
  }
  return file_names(folder).size() == count ? "" : "it has files that were not written with it";
}

}  // namespace tools
