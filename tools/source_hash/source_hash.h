#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tools {

/// Sources whose compiled code is to be told by a hash.
struct SourceSet {
  std::vector<std::filesystem::path> folders;  ///< where names are looked up, the first one first
  std::vector<std::string> sources;            ///< names of the files that are compiled
  std::vector<std::string> facts;  ///< what else the code depends on, such as a compiler
};

/// Returns the set that a text of lines `folder PATH`, `source NAME` and `fact TEXT` describes.
/// Throws vo::Error for another line.
SourceSet parse_source_set(const std::string& text);

struct SourceHash {
  std::string hash;                          ///< ContentHash, 32 hexadecimal digits
  std::vector<std::filesystem::path> files;  ///< all files that were read, sorted by name
};

/// Returns the hash of the facts, of the sources and of every header that they include, directly or
/// not, in quotes. Comments do not count, nor does the length of white space; names do. Throws
/// vo::Error naming a file that is in none of the folders.
SourceHash hash_sources(const SourceSet& set);

}  // namespace tools
