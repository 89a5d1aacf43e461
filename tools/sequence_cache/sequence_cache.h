#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "synth/sequence/render_sequence.h"
#include "vo/core/progress.h"
#include "vo/files/file_lock.h"

namespace tools {

/// An entry of the cache, a folder of rendered sequences whose keys are hashes of all that
/// determines them: the scene's files, the recipe, the generator's sources with every header that
/// they include, its compiler and libraries. Any number of processes may use one cache at once.
///     sequences/<key>/         the sequence
///     sequences/<key>.part/    the sequence while it is rendered
///     sequences/<key>.files    size and hash of each file of the sequence
///     locks/<key>              lock while the sequence is rendered or used; time of its last use
///     results/<key>.jsonl      metrics of edvo's own tracker on a sequence (`trial_file.h`)
struct CachedSequence {
  std::filesystem::path folder;
  std::string content;  ///< hash of the sequence's files
  std::string problem;  ///< why an existing entry was rendered again; usually empty
  vo::FileLock in_use;  ///< shared lock that keeps the sequence from being removed
};

/// Returns the folder that was chosen or, if that is empty, $XDG_CACHE_HOME/edvo, or ~/.cache/edvo
/// where that is not set to an absolute path.
std::filesystem::path cache_folder(const std::filesystem::path& chosen);

/// Returns the cached sequence; renders it if it is missing or its files changed. `progress` is
/// told of the rendering, and (0, 0) while another process holds the lock.
CachedSequence cached_sequence(const std::filesystem::path& cache, const synth::RenderJob& job,
                               const vo::Progress& progress);

struct CacheEntry {
  std::string key;
  std::string scene;  ///< file name of the scene
  std::size_t frames = 0;
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type last_used;
  std::string problem;  ///< what is wrong with the files; set by `verify_cache`
};

/// Returns the entries in order of their last use, the oldest first.
std::vector<CacheEntry> list_cache(const std::filesystem::path& cache);

/// Returns the entries after reading every file: `problem` says what is wrong, and such entries are
/// removed unless in use.
std::vector<CacheEntry> verify_cache(const std::filesystem::path& cache,
                                     const vo::Progress& progress);

/// Removes the least recently used entries until the rest has at most `max_bytes`, and unfinished
/// ones of killed processes. Entries in use stay. Returns the removed entries.
std::vector<CacheEntry> prune_cache(const std::filesystem::path& cache, std::uintmax_t max_bytes);

}  // namespace tools
