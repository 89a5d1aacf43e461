#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "vo/files/output.h"
#include "vo/files/output_lock.h"

namespace vo {

/// A folder that appears under its name only when it is complete: it is filled as
/// `.<name>.partial-edvo` beside that name and renamed by `commit`. One process at a time makes it;
/// what a killed one left is removed. The destructor removes a folder that was not committed.
class OutputFolder {
 public:
  /// Waits for others that make the same folder, and makes an empty one. Throws Error if that
  /// fails.
  OutputFolder(const std::filesystem::path& path, const OutputPolicy& policy,
               const WaitObserver& waiting);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;

  /// Writes files into the folder, and the folders that hold them.
  void write(const std::vector<NamedBytes>& files) const;

  /// Adds the list of the files (`kFileList`) and gives the folder its final name, which must be
  /// free as `require_replaceable` demands. An existing folder with equal files is left alone.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path partial_;
  OutputPolicy policy_;
  std::optional<OutputLock> lock_;
};

/// Waits until a folder and all that is below are on the disk. Throws Error where that fails.
void sync_tree(const std::filesystem::path& folder);

/// Gives the owner of a folder, and of all folders below it, the permission to remove what they
/// hold. Throws Error where a folder is somebody else's and its content cannot be removed.
void allow_removal(const std::filesystem::path& folder);

/// Renames a folder to `path` and syncs both as the policy says; a folder that is there is removed,
/// once the new one has its name. Throws Error before anything is renamed where it could not be.
/// The caller holds the lock of `path` and has called `require_replaceable`.
void put_folder_in_place(const std::filesystem::path& made, const std::filesystem::path& path,
                         Durability durability);

/// Removes what killed processes left beside `path`, and gives back its name to a folder that was
/// about to be replaced. The caller holds the lock of `path`.
void remove_leftovers(const std::filesystem::path& path);

/// Removes what killed processes left beside `path` unless somebody is making it; does nothing
/// where that cannot be done.
void tidy_up_beside(const std::filesystem::path& path);

/// Makes the folders above a place to write. Throws Error where that fails, or where `path` is the
/// current folder or one above it. All paths of this header but that of OutputFolder are as
/// `resolved_output` gives them.
void prepare_place(const std::filesystem::path& path);

}  // namespace vo
