#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/files/output.h"
#include "vo/files/output_lock.h"
#include "vo/files/partial_file.h"
#include "vo/output_folders/part_records.h"

namespace vo {

/// Files of a folder that are made together.
struct FolderPart {
  std::string name;                ///< name of its record, unique in the folder
  std::vector<std::string> files;  ///< paths within the folder
};

/// What a folder will hold.
struct StagedContent {
  NamedBytes marker;  ///< the file that says what the folder is filled with
  std::vector<FolderPart> parts;
  std::vector<NamedBytes> rest;  ///< files of no part, written when all parts are there
  /// Folders within it that stand alone, too, and therefore get lists of their own files.
  std::vector<std::string> folders{};
};

/// A folder that several processes fill, at once or one after the other, part by part: it is
/// `<name>.part` beside its final name until `finish`, and stays there when a run ends early. Only
/// runs with equal markers share it. Each part is made by one process at a time, and recorded with
/// size and hash of its files when it is done; `finish` lets nothing pass that is not as recorded.
/// The folder of those records is what tells an unfinished folder from a finished one that has
/// `<name>.part` as its own name: that one is never joined, and never replaced.
class StagedFolder {
 public:
  /// Makes the folder, or joins one with an equal marker, and removes what killed processes left
  /// beside it. One with another marker is begun anew with `replace`; with `keep` it is an Error of
  /// kind output_exists, and while others fill it one of kind temporary. A finished folder is read:
  /// one with damaged files is made anew with `replace`, and an Error that names a file with
  /// `keep`. A folder `<name>.part` that holds something and is not unfinished is an Error of kind
  /// input. `content` must outlive the object.
  StagedFolder(const std::filesystem::path& path, const StagedContent& content,
               const OutputPolicy& policy, WaitObserver waiting);

  static std::filesystem::path staging_of(const std::filesystem::path& path);

  const std::filesystem::path& staging() const { return staging_; }  ///< folder to write into

  /// Returns whether the final folder is there with this content, its files with their sizes; with
  /// their bytes where those were damaged when the object was made.
  bool is_finished() const;

  /// Returns whether a part is recorded, and its files are there with their sizes.
  bool has(const FolderPart& part) const;

  /// Returns the right to make a part, or nothing when another process makes it or it is there.
  std::optional<PartialFile> claim(const FolderPart& part) const;

  /// Writes the files of a part and its record, after which it is there.
  void put(PartialFile claim, const std::vector<NamedBytes>& files) const;

  /// Waits until nobody else fills the folder, verifies the bytes of all parts, writes the rest and
  /// the list of all files and gives the folder its final name, which must be free as
  /// `require_replaceable` demands. Returns the indices of parts whose files are not as recorded,
  /// having removed those files; then nothing else was done. All parts must be there before. Where
  /// another process has finished the folder, it does nothing.
  std::vector<std::size_t> finish();

 private:
  void join();
  bool begin_or_join_alone();
  bool is_joined() const;
  void look_for_damage();
  bool is_unfinished() const;
  void begin() const;
  void take_back_complete() const;
  void require_free_staging() const;
  void put_in_place() const;
  std::vector<std::size_t> remove_damaged(FileRecords& records) const;

  std::filesystem::path path_;
  std::filesystem::path staging_;
  std::filesystem::path complete_;  ///< name of the folder from its last file to its final name
  const StagedContent& content_;
  OutputPolicy policy_;
  WaitObserver waiting_;
  bool was_damaged_ = false;  ///< whether a finished folder had other bytes than were written
  std::optional<OutputLock> lock_;
  std::optional<PartRecords> records_;
};

}  // namespace vo
