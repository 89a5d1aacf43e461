#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "synth/sequence/render_sequence.h"
#include "tools/processes/file_lock.h"
#include "vo/core/progress.h"

namespace tools {

/// A folder of rendered sequences, each under the hash of all that determines it: the scene's
/// files, the recipe, and the sources of the generator. Any number of processes may use one cache
/// at once.
///     sequences/<key>/         the sequence
///     sequences/<key>.part/    the same while it is made
///     sequences/<key>.files    size and hash of each of its files
///     locks/<key>              held while the sequence is made or used; when it was last used
///     results/<key>.json       what was measured on sequences (`kept_results.h`)
struct CachedSequence {
  std::filesystem::path folder;
  std::string content;  ///< hash of its files: the same bytes have the same
  std::string problem;  ///< what was wrong with the entry before it was made again; mostly empty
  FileLock in_use;      ///< nobody removes the sequence while this exists
};

/// $XDG_CACHE_HOME/edvo, or ~/.cache/edvo where that is not set.
std::filesystem::path default_cache_folder();

/// The sequence, rendered unless it is there and its files are what they were. `progress` is told
/// of the rendering, and (0, 0) while another process makes the same sequence.
CachedSequence cached_sequence(const std::filesystem::path& cache, const synth::RenderJob& job,
                               const vo::Progress& progress);

struct CacheEntry {
  std::string key;
  std::string scene;  ///< file name
  std::size_t frames = 0;
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type last_used;
  std::string problem;  ///< set by `verify_cache`
};

/// In order of their last use, the oldest first.
std::vector<CacheEntry> list_cache(const std::filesystem::path& cache);

/// The same after every file was read: `problem` says what is wrong, and such entries are removed.
std::vector<CacheEntry> verify_cache(const std::filesystem::path& cache,
                                     const vo::Progress& progress);

/// Removes the entries that were not used for longest until the rest has at most `max_bytes`, and
/// what killed processes left. Entries in use stay. Returns what was removed.
std::vector<CacheEntry> prune_cache(const std::filesystem::path& cache, std::uintmax_t max_bytes);

}  // namespace tools
