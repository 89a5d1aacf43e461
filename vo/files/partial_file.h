#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "vo/files/file_lock.h"
#include "vo/files/output.h"

namespace vo {

/// Returns the name of what is being written: `.NAME.partial-edvo` beside it, and an
/// extension behind it for writers that choose a format by it.
std::filesystem::path partial_name(const std::filesystem::path& path,
                                   const std::filesystem::path& extension = {});

/// Returns whether a file or folder has a name that `partial_name` gives without an extension.
bool is_partial_name(const std::filesystem::path& path);

/// A file while it is being written, under its `partial_name` and locked: only one process or
/// thread at a time writes a file, and what a killed one left is taken over by the next; a folder
/// that a killed one left under this name is removed. The
/// destructor removes a file that was not committed.
class PartialFile {
 public:
  /// Waits for others that write the same file. Throws Error, `temporary` when they take a minute.
  explicit PartialFile(const std::filesystem::path& path,
                       const std::filesystem::path& extension = {},
                       const WaitObserver& waiting = {});

  /// Returns nothing when somebody else writes the file.
  static std::optional<PartialFile> try_open(const std::filesystem::path& path,
                                             const std::filesystem::path& extension = {});

  ~PartialFile();
  PartialFile(PartialFile&& other) noexcept;
  PartialFile& operator=(PartialFile&&) = delete;
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Returns where the file is until it is committed.
  const std::filesystem::path& partial_path() const { return partial_; }

  /// Writes bytes behind those before.
  void append(std::string_view bytes);

  /// Gives the file its final name, in place of a file that is there.
  void commit(Durability durability);

  /// Writes bytes and gives the file its final name.
  void commit(std::string_view bytes, Durability durability);

 private:
  PartialFile(std::filesystem::path path, std::filesystem::path partial, FileLock lock);

  std::filesystem::path path_;
  std::filesystem::path partial_;
  std::optional<FileLock> lock_;  ///< nothing once committed or moved from
  bool is_begun_ = false;         ///< whether what a killed process left is gone
};

/// Removes the partial file or folder that a killed process left of `path`, if any.
void remove_abandoned(const std::filesystem::path& path);

/// Writes bytes into an open file. `path` is named by the Error that it throws where that fails.
void write_bytes(int descriptor, std::string_view bytes, const std::filesystem::path& path);

/// Waits until a file or folder is on the disk. Throws Error where that fails.
void sync_to_disk(const std::filesystem::path& path);

}  // namespace vo
