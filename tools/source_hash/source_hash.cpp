#include "tools/source_hash/source_hash.h"

#include <map>
#include <optional>
#include <sstream>

#include "tools/source_hash/source_text.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/hashing/content_hash.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

fs::path find_file(const std::vector<fs::path>& folders, const std::string& name) {
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / name)) {
      return folder / name;
    }
  }
  vo::fail(name, ": is in none of the folders of sources");
}

/// Returns the name that a line of code includes in quotes, if it does.
std::optional<std::string> included_name(std::string_view line) {
  constexpr std::string_view kInclude = "include";
  if (!line.starts_with('#')) {
    return {};
  }
  line.remove_prefix(line.find_first_not_of("# "));
  const std::size_t quote = line.find('"');
  if (!line.starts_with(kInclude) || quote == std::string_view::npos) {
    return {};
  }
  return std::string(line.substr(quote + 1, line.find('"', quote + 1) - quote - 1));
}

}  // namespace

SourceSet parse_source_set(const std::string& text) {
  SourceSet set;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    const std::string kind = line.substr(0, space);
    const std::string rest = space == std::string::npos ? "" : line.substr(space + 1);
    if (kind == "folder") {
      set.folders.emplace_back(rest);
    } else if (kind == "source") {
      set.sources.push_back(rest);
    } else {
      vo::require(kind == "fact", line, ": expected folder, source or fact");
      set.facts.push_back(rest);
    }
  }
  return set;
}

SourceHash hash_sources(const SourceSet& set) {
  std::map<std::string, std::string> codes;  // by name
  SourceHash result;
  std::vector<std::string> open = set.sources;
  std::map<std::string, fs::path> files;
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (files.contains(name)) {
      continue;
    }
    files[name] = find_file(set.folders, name);
    codes[name] = without_comments(vo::read_file(files[name]));
    std::istringstream lines(codes[name]);
    for (std::string line; std::getline(lines, line);) {
      if (const auto included = included_name(line)) {
        open.push_back(*included);
      }
    }
  }
  vo::ContentHash hash;
  for (const std::string& fact : set.facts) {
    hash.add(vo::content_hash(fact));
  }
  for (const auto& [name, code] : codes) {
    hash.add(vo::content_hash(name));
    hash.add(vo::content_hash(code));
    result.files.push_back(files.at(name));
  }
  result.hash = hash.hex();
  return result;
}

}  // namespace tools
