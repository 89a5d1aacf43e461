#include "vo/output_folders/output_folder.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/files/system_failure.h"
#include "vo/output_folders/file_records.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

/// Returns the name of a folder while another takes its place.
fs::path old_name(const fs::path& path) {
  return path.parent_path() / ("." + path.filename().string() + ".old-edvo");
}

bool have_same_files(const fs::path& a, const fs::path& b) {
  const std::vector<std::string> files = files_below(a);
  return files == files_below(b) &&
         std::all_of(files.begin(), files.end(), [&](const std::string& file) {
           return read_file(a / file) == read_file(b / file);
         });
}

/// Throws Error if the current folder is `path` or lies in it, because `path` is to be replaced.
void require_elsewhere(const fs::path& path) {
  const std::string here = fs::current_path().string() + "/";
  require(!here.starts_with(path.string() + "/") || !fs::exists(path) || fs::is_empty(path),
          path.string(), ": is the current folder or one above it, expected another to write");
}

/// Throws Error if a file system is mounted at `path`, whose name no other folder can get.
void require_no_mount_point(const fs::path& path) {
  struct statx status {};
  const bool is_known = ::statx(AT_FDCWD, path.c_str(), 0, STATX_BASIC_STATS, &status) == 0 &&
                        (status.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT) != 0;
  require(!is_known || (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) == 0, path.string(),
          ": is a mount point, which a finished folder cannot replace, expected a name within it");
}

/// Removes what was replaced, as far as it can be.
void remove_old_folder(const fs::path& old) {
  try {
    allow_removal(old);
  } catch (const Error&) {  // whoever replaces a folder again is told of it
  }
  remove_tree(old);
}

/// Removes what was replaced earlier; throws Error where that cannot be done.
void require_no_old_folder(const fs::path& path) {
  const fs::path old = old_name(path);
  remove_old_folder(old);
  require(!fs::exists(fs::symlink_status(old)), path.string(),
          ": cannot be replaced: an earlier result, ", old.string(),
          ", cannot be removed; remove it");
}

}  // namespace

void allow_removal(const fs::path& folder) {
  struct stat status {};
  if (::lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
    return;
  }
  if ((status.st_mode & S_IRWXU) != S_IRWXU && status.st_uid == ::geteuid()) {
    ::chmod(folder.c_str(), (status.st_mode & ~S_IFMT) | S_IRWXU);
  }
  if (::faccessat(AT_FDCWD, folder.c_str(), R_OK | W_OK | X_OK, AT_EACCESS) != 0) {
    fail_with(folder, "cannot be replaced", errno);
  }
  for (const FolderEntry& entry : entries_of(folder)) {
    if (entry.kind == EntryKind::folder) {
      allow_removal(folder / entry.name);
    }
  }
}

void sync_tree(const fs::path& folder) {
  for (const FolderEntry& entry : entries_below(folder)) {
    if (entry.kind == EntryKind::file || entry.kind == EntryKind::folder) {
      sync_to_disk(folder / entry.name);
    }
  }
  sync_to_disk(folder);
}

void put_folder_in_place(const fs::path& made, const fs::path& path, Durability durability) {
  if (durability == Durability::synced) {
    sync_tree(made);
  }
  const bool is_replaced = fs::exists(path);
  if (is_replaced) {
    require_no_old_folder(path);
    allow_removal(path);
    rename_entry(path, old_name(path));
  }
  try {
    rename_entry(made, path);
  } catch (const Error&) {
    remove_leftovers(path);  // gives back the old folder's name
    throw;
  }
  if (durability == Durability::synced) {
    sync_to_disk(path.parent_path());
  }
  if (is_replaced) {
    remove_tree(old_name(path));
  }
}

void remove_leftovers(const fs::path& path) {
  const fs::path old = old_name(path);
  if (fs::exists(old) && !fs::exists(path)) {
    rename_entry(old, path);
  }
  remove_old_folder(old);
  remove_tree(partial_name(path));
}

void tidy_up_beside(const fs::path& path) {
  try {
    if (const auto lock = OutputLock::try_lock(path, LockKind::exclusive)) {
      remove_leftovers(path);
    }
  } catch (const Error&) {  // the place is read-only: nobody has left anything there
  }
}

void prepare_place(const fs::path& path) {
  require_elsewhere(path);
  require_no_mount_point(path);
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) {
    fail_with(path, "cannot be written", error.value());
  }
}

OutputFolder::OutputFolder(const fs::path& path, const OutputPolicy& policy,
                           const WaitObserver& waiting)
    : path_(resolved_output(path)), partial_(partial_name(path_)), policy_(policy) {
  prepare_place(path_);
  lock_.emplace(path_, LockKind::exclusive, waiting);
  remove_leftovers(path_);
  if (policy_.existing == ExistingOutput::replace) {
    require_replaceable(path_, policy_.existing);
  }
  std::error_code error;
  fs::create_directory(partial_, error);
  if (error) {
    fail_with(path, "cannot be written", error.value());
  }
}

OutputFolder::~OutputFolder() {
  remove_tree(partial_);
}

void OutputFolder::write(const std::vector<NamedBytes>& files) const {
  write_files(partial_, files, {ExistingOutput::replace, Durability::unsynced});
}

void OutputFolder::commit() {
  FileRecords records;
  for (const std::string& file : files_below(partial_)) {
    records[file] = record_of(read_file(partial_ / file));
  }
  write({{kFileList, format_records(records)}});
  if (fs::is_directory(path_) && have_same_files(path_, partial_)) {
    return;
  }
  require_replaceable(path_, policy_.existing);
  put_folder_in_place(partial_, path_, policy_.durability);
}

}  // namespace vo
