#include "vo/output_folders/staged_folder.h"

#include <algorithm>
#include <utility>

#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/result_files.h"
#include "vo/output_folders/file_records.h"
#include "vo/output_folders/output_folder.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr OutputPolicy kWithinStaging{ExistingOutput::replace, Durability::unsynced};

/// Returns the list of what a folder will hold, nothing of it written.
FileRecords planned(const StagedContent& content) {
  FileRecords records;
  for (const FolderPart& part : content.parts) {
    for (const std::string& file : part.files) {
      records[file];
    }
  }
  for (const NamedBytes& file : content.rest) {
    records[file.name];
  }
  for (const std::string& folder : content.folders) {
    records[concat(folder, "/", kFileList)];
  }
  records[content.marker.name];
  return records;
}

/// Returns the list of the files in a folder within the one that records are of.
NamedBytes list_within(const std::string& folder, const FileRecords& records) {
  const std::string prefix = folder + "/";
  FileRecords own;
  for (const auto& [name, record] : records) {
    if (name.starts_with(prefix)) {
      own[name.substr(prefix.size())] = record;
    }
  }
  return {prefix + kFileList, format_records(own)};
}

bool holds_marker(const fs::path& folder, const NamedBytes& marker) {
  const fs::path file = folder / marker.name;
  return fs::is_regular_file(file) && read_file(file) == marker.bytes;
}

/// Removes all that `PartialFile` left in a folder that nobody else writes into.
void remove_partial_files(const fs::path& folder) {
  for (const std::string& file : files_below(folder)) {
    if (is_partial_name(file)) {
      fs::remove(folder / file);
    }
  }
}

}  // namespace

StagedFolder::StagedFolder(const fs::path& path, const StagedContent& content,
                           const OutputPolicy& policy, WaitObserver waiting)
    : path_(resolved_output(path)),
      staging_(staging_of(path)),
      complete_(partial_name(path_)),
      content_(content),
      policy_(policy),
      waiting_(std::move(waiting)) {
  look_for_damage();
  if (is_finished()) {
    tidy_up_beside(path_);
  } else {
    prepare_place(path_);
    join();
  }
  records_.emplace(staging_);
}

fs::path StagedFolder::staging_of(const fs::path& path) {
  return resolved_output(path).string() + ".part";
}

bool StagedFolder::is_unfinished() const {
  return fs::is_directory(staging_ / part_record_name(""));
}

bool StagedFolder::is_joined() const {
  return is_unfinished() && holds_marker(staging_, content_.marker);
}

bool StagedFolder::is_finished() const {
  if (!holds_marker(path_, content_.marker)) {
    return false;
  }
  const FileRecords records = read_list(path_);
  const FileRecords names = planned(content_);
  return std::all_of(names.begin(), names.end(), [&](const auto& name) {
    const auto found = records.find(name.first);
    return found != records.end() && (was_damaged_ ? is_intact(path_, name.first, found->second)
                                                   : has_size(path_, name.first, found->second));
  });
}

/// Reads a finished folder, and remembers whether its files have the bytes that were written.
void StagedFolder::look_for_damage() {
  if (!is_finished()) {
    return;
  }
  const FileRecords records = read_list(path_);
  const auto damaged = std::find_if(records.begin(), records.end(), [&](const auto& file) {
    return !is_intact(path_, file.first, file.second);
  });
  if (damaged == records.end()) {
    return;
  }
  if (policy_.existing == ExistingOutput::keep) {
    fail_as(ErrorKind::output_exists, (path_ / damaged->first).string(),
            ": has other bytes than were written; --force makes ", path_.filename().string(),
            " again");
  }
  was_damaged_ = true;
}

/// Makes the folder with its marker, the folder of its records and, from the start, the list of
/// what is planned in it.
void StagedFolder::begin() const {
  const fs::path fresh = partial_name(staging_);
  remove_completely(fresh);
  try {
    write_files(fresh,
                {content_.marker, {std::string(kFileList), format_records(planned(content_))}},
                kWithinStaging);
    make_folder(fresh / part_record_name(""));
    rename_entry(fresh, staging_);
  } catch (const Error&) {
    remove_tree(fresh);
    throw;
  }
}

/// Makes a complete folder that a killed run left without its final name one to be filled again.
void StagedFolder::take_back_complete() const {
  if (!holds_marker(complete_, content_.marker) || fs::exists(staging_)) {
    return;
  }
  make_folder(complete_ / part_record_name(""));
  rename_entry(complete_, staging_);
}

/// Throws Error unless the folder's name is free, or is that of an unfinished folder.
void StagedFolder::require_free_staging() const {
  const bool is_free = !fs::exists(staging_) || is_unfinished() ||
                       (fs::is_directory(staging_) && fs::is_empty(staging_));
  require(is_free, staging_.string(), ": is no unfinished result of ", path_.filename().string(),
          ", which needs that name until it is finished; rename it, or write to another name");
}

/// Puts the place in order, alone: returns whether there is a folder to fill or a finished one.
bool StagedFolder::begin_or_join_alone() {
  take_back_complete();
  remove_leftovers(path_);
  if (is_finished()) {
    return true;
  }
  require_replaceable(path_, policy_.existing);
  require_free_staging();
  if (fs::exists(staging_) && !is_joined()) {
    require_replaceable(staging_, policy_.existing);
    remove_completely(staging_);
  }
  if (!fs::exists(staging_)) {
    begin();
  }
  lock_->share();
  return is_finished() || is_joined();
}

void StagedFolder::join() {
  for (;;) {
    if (auto alone = OutputLock::try_lock(path_, LockKind::exclusive)) {
      lock_.emplace(std::move(*alone));
      if (begin_or_join_alone()) {
        return;
      }
    } else if (auto with_others = OutputLock::try_lock(path_, LockKind::shared)) {
      lock_.emplace(std::move(*with_others));
      if (is_finished() || is_joined()) {
        return;
      }
      if (fs::exists(staging_)) {
        fail_as(ErrorKind::temporary, staging_.string(),
                ": is being filled by another run for another result");
      }
    }
    lock_.reset();
    pause_for_others(waiting_);
  }
}

bool StagedFolder::has(const FolderPart& part) const {
  return records_->has(part.name, part.files);
}

std::optional<PartialFile> StagedFolder::claim(const FolderPart& part) const {
  const fs::path record = staging_ / part_record_name(part.name);
  make_folder(record.parent_path());
  std::optional<PartialFile> claim = PartialFile::try_open(record);
  if (claim && has(part)) {
    claim.reset();
  }
  return claim;
}

void StagedFolder::put(PartialFile claim, const std::vector<NamedBytes>& files) const {
  FileRecords records;
  for (const NamedBytes& file : files) {
    records[file.name] = record_of(file.bytes);
  }
  write_files(staging_, files, kWithinStaging);
  claim.commit(format_records(records), Durability::unsynced);
}

/// Returns the indices of damaged parts, whose files are gone then, and adds the records of the
/// others.
std::vector<std::size_t> StagedFolder::remove_damaged(FileRecords& records) const {
  std::vector<std::size_t> damaged;
  for (std::size_t i = 0; i < content_.parts.size(); ++i) {
    const FolderPart& part = content_.parts[i];
    const FileRecords own = records_->of(part.name, part.files);
    bool is_whole = own.size() == part.files.size();
    for (const auto& [file, record] : own) {
      if (!is_intact(staging_, file, record)) {
        is_whole = false;
        fs::remove(staging_ / file);
      }
    }
    if (!is_whole) {
      damaged.push_back(i);
    }
    records.insert(own.begin(), own.end());
  }
  return damaged;
}

std::vector<std::size_t> StagedFolder::finish() {
  lock_.reset();
  lock_.emplace(path_, LockKind::exclusive, waiting_);
  if (is_finished()) {
    return {};
  }
  if (!is_joined()) {
    fail_as(ErrorKind::temporary, staging_.string(), ": was begun anew by another run");
  }
  FileRecords records;
  std::vector<std::size_t> damaged = remove_damaged(records);
  if (!damaged.empty()) {
    lock_.reset();
    join();
    records_.emplace(staging_);
    return is_finished() ? std::vector<std::size_t>() : damaged;
  }
  remove_partial_files(staging_);
  write_files(staging_, content_.rest, kWithinStaging);
  for (const NamedBytes& file : content_.rest) {
    records[file.name] = record_of(file.bytes);
  }
  records[content_.marker.name] = record_of(content_.marker.bytes);
  for (const std::string& folder : content_.folders) {
    const NamedBytes list = list_within(folder, records);
    write_files(staging_, {list}, kWithinStaging);
    records[list.name] = record_of(list.bytes);
  }
  write_files(staging_, {{std::string(kFileList), format_records(records)}}, kWithinStaging);
  require_replaceable(path_, policy_.existing);
  put_in_place();
  return {};
}

/// Gives the folder its final name. It loses its records, by which it would be known as
/// unfinished, under a name that no user's folder has.
void StagedFolder::put_in_place() const {
  remove_completely(complete_);
  rename_entry(staging_, complete_);
  remove_completely(complete_ / part_record_name(""));
  put_folder_in_place(complete_, path_, policy_.durability);
}

}  // namespace vo
