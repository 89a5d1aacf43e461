#include "tools/sequence_cache/sequence_cache.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "synth/environment/environment.h"
#include "synth/gltf/gltf.h"
#include "tools/sequence_cache/folder_hash.h"
#include "tools/sequence_cache/generator_hash.h"
#include "tools/sequence_cache/scene_files_hash.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/output.h"
#include "vo/files/partial_file.h"
#include "vo/files/result_files.h"
#include "vo/hashing/content_hash.h"
#include "vo/output_folders/output_folder.h"
#include "vo/output_folders/staged_folder.h"
#include "vo/text_files/toml_file.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Nothing here is waited for until it is on the disk: what a loss of power damages is found by its
/// hash and made again.
constexpr vo::OutputPolicy kVerifiedWhenRead{vo::ExistingOutput::replace, vo::Durability::unsynced};

struct EntryPlaces {
  fs::path sequence;
  fs::path files;
  fs::path lock;
};

EntryPlaces places_of(const fs::path& cache, const std::string& key) {
  return {cache / "sequences" / key, cache / "sequences" / (key + ".files"), cache / "locks" / key};
}

std::string key_of(const synth::RenderJob& job) {
  synth::GltfOptions parts = job.scene.options();
  if (synth::is_environment_file(parts.environment)) {
    parts.environment = vo::content_hash(vo::read_file(parts.environment));
  }
  std::string actors;
  for (const synth::ActorOptions& actor : job.scene.actors()) {
    actors += vo::concat(scene_files_hash(actor.file), "\n");
  }
  return vo::content_hash(vo::concat(generator_hash(), "\n", scene_files_hash(job.scene.path()),
                                     "\n", vo::format_toml(vo::fields_of(parts)), "\n", actors,
                                     synth::format_recipe(job)));
}

/// Returns the hash of all files of an entry.
std::string content_of(const EntryPlaces& places) {
  return vo::content_hash(vo::read_file(places.files));
}

/// Returns what is wrong with an existing entry; empty when nothing is.
std::string problem_of(const EntryPlaces& places) {
  if (!fs::exists(places.files)) {
    return "it was left unfinished";
  }
  return find_difference(places.sequence, vo::read_file(places.files));
}

/// Returns whether a name is that of an entry, 32 hexadecimal digits: nothing else in the folder is
/// ever removed.
bool is_key(const std::string& name) {
  return name.size() == vo::content_hash("").size() &&
         name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Throws vo::Error naming the entry where it cannot be removed.
void remove_entry(const EntryPlaces& places) {
  vo::remove_completely(places.files);
  vo::remove_completely(places.sequence);
}

/// Returns the key of an unfinished sequence by the name of a folder in the cache, `KEY.part` or
/// the partial name of that or of `KEY`; nothing for the name of another folder.
std::optional<std::string> unfinished_key(const fs::path& name) {
  const bool is_partial = vo::is_partial_name(name);
  const fs::path shown = is_partial ? fs::path(name.stem().string().substr(1)) : name;
  const std::string key = shown.stem().string();
  const bool is_staging = vo::StagedFolder::staging_of(key).filename() == shown;
  const bool is_unfinished = is_key(key) && (is_staging || (is_partial && shown == key));
  return is_unfinished ? std::optional(key) : std::nullopt;
}

/// Removes unfinished sequences of processes that were killed while rendering.
void remove_unfinished(const fs::path& cache) {
  std::set<std::string> keys;
  if (fs::is_directory(cache / "sequences")) {
    for (const auto& [entry, kind] : vo::entries_of(cache / "sequences")) {
      if (const auto key = unfinished_key(entry); key && kind == vo::EntryKind::folder) {
        keys.insert(*key);
      }
    }
  }
  for (const std::string& key : keys) {
    const EntryPlaces places = places_of(cache, key);
    if (const auto lock = vo::FileLock::try_lock(places.lock, vo::LockKind::exclusive)) {
      const fs::path staging = vo::StagedFolder::staging_of(places.sequence);
      for (const fs::path& left :
           {staging, vo::partial_name(staging), vo::partial_name(places.sequence)}) {
        vo::remove_tree(left);
      }
    }
  }
}

std::string value_of(const std::vector<vo::TomlValue>& values, const std::string& key) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const vo::TomlValue& value) { return value.key == key; });
  return found == values.end() ? "" : found->text;
}

std::uintmax_t size_of(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& [name, kind] : vo::entries_below(folder)) {
    bytes += kind == vo::EntryKind::file ? fs::file_size(folder / name) : 0;
  }
  return bytes;
}

/// Returns the description of an entry; empty if it is being removed.
std::optional<CacheEntry> describe_entry(const fs::path& cache, const std::string& key) {
  const EntryPlaces places = places_of(cache, key);
  try {
    CacheEntry entry{.key = key, .bytes = size_of(places.sequence)};
    entry.last_used = fs::last_write_time(fs::exists(places.lock) ? places.lock : places.sequence);
    const fs::path manifest = places.sequence / "sequence.toml";
    if (fs::exists(manifest)) {
      const std::vector<vo::TomlValue> values = vo::read_toml(manifest);
      entry.scene = value_of(values, "scene");
      const std::string frames = value_of(values, "frames");
      entry.frames = frames.empty() ? 0 : static_cast<std::size_t>(vo::parse_integer(frames));
    }
    return entry;
  } catch (const fs::filesystem_error&) {
    return {};
  } catch (const vo::Error&) {
    return CacheEntry{.key = key};
  }
}

std::vector<std::string> keys_in(const fs::path& cache) {
  std::vector<std::string> keys;
  if (fs::is_directory(cache / "sequences")) {
    for (const auto& [name, kind] : vo::entries_of(cache / "sequences")) {
      if (kind == vo::EntryKind::folder && is_key(name)) {
        keys.push_back(name);
      }
    }
  }
  return keys;
}

}  // namespace

fs::path cache_folder(const fs::path& chosen) {
  if (!chosen.empty()) {
    return chosen;
  }
  const char* cache = std::getenv("XDG_CACHE_HOME");  // NOLINT(concurrency-mt-unsafe)
  if (cache != nullptr && fs::path(cache).is_absolute()) {
    return fs::path(cache) / "edvo";
  }
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
  vo::require(home != nullptr && fs::path(home).is_absolute(), "HOME is ",
              home == nullptr ? "not set" : vo::concat("\"", home, "\""),
              ", expected a folder's full path, or XDG_CACHE_HOME or --cache DIR");
  return fs::path(home) / ".cache" / "edvo";
}

CachedSequence cached_sequence(const fs::path& cache, const synth::RenderJob& job,
                               const vo::Progress& progress) {
  vo::make_folder(cache / "sequences");
  vo::make_folder(cache / "locks");
  const EntryPlaces places = places_of(cache, key_of(job));
  const vo::WaitObserver waiting = [&] { progress(0, 0); };
  {
    vo::FileLock lock(places.lock, vo::LockKind::shared, waiting);
    if (fs::exists(places.sequence) && problem_of(places).empty()) {
      vo::tidy_up_beside(places.sequence);
      return {places.sequence, content_of(places), "", std::move(lock)};
    }
  }
  vo::FileLock lock(places.lock, vo::LockKind::exclusive, waiting);
  std::string problem = fs::exists(places.sequence) ? problem_of(places) : "";
  if (!fs::exists(places.sequence) || !problem.empty()) {
    remove_entry(places);
    synth::render_sequence(job, places.sequence, kVerifiedWhenRead, progress);
    vo::write_file(places.files, list_file_hashes(places.sequence), kVerifiedWhenRead);
  }
  lock.share();
  return {places.sequence, content_of(places), std::move(problem), std::move(lock)};
}

std::vector<CacheEntry> list_cache(const fs::path& cache) {
  std::vector<CacheEntry> entries;
  for (const std::string& key : keys_in(cache)) {
    if (std::optional<CacheEntry> entry = describe_entry(cache, key)) {
      entries.push_back(std::move(*entry));
    }
  }
  std::sort(entries.begin(), entries.end(), [](const CacheEntry& a, const CacheEntry& b) {
    return std::tie(a.last_used, a.key) < std::tie(b.last_used, b.key);
  });
  return entries;
}

std::vector<CacheEntry> verify_cache(const fs::path& cache, const vo::Progress& progress) {
  std::vector<CacheEntry> entries = list_cache(cache);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const EntryPlaces places = places_of(cache, entries[i].key);
    const std::filesystem::file_time_type used = entries[i].last_used;
    const auto lock = vo::FileLock::try_lock(places.lock, vo::LockKind::exclusive);
    if (lock) {
      entries[i].problem = problem_of(places);
      if (!entries[i].problem.empty()) {
        remove_entry(places);
      }
      std::error_code ignored;
      fs::last_write_time(places.lock, used, ignored);
    }
    progress(i + 1, entries.size());
  }
  return entries;
}

std::vector<CacheEntry> prune_cache(const fs::path& cache, std::uintmax_t max_bytes) {
  remove_unfinished(cache);
  const std::vector<CacheEntry> entries = list_cache(cache);
  std::uintmax_t total = 0;
  for (const CacheEntry& entry : entries) {
    total += entry.bytes;
  }
  std::vector<CacheEntry> removed;
  for (const CacheEntry& entry : entries) {
    const EntryPlaces places = places_of(cache, entry.key);
    const auto lock = total > max_bytes
                          ? vo::FileLock::try_lock(places.lock, vo::LockKind::exclusive)
                          : std::optional<vo::FileLock>();
    if (lock) {
      remove_entry(places);
      total -= entry.bytes;
      removed.push_back(entry);
    }
  }
  return removed;
}

}  // namespace tools
