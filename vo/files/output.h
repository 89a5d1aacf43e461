#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// A file that is still to be written into a folder.
struct NamedBytes {
  std::string name;  ///< path within the folder
  std::string bytes;
};

/// What to do when the output exists already and differs from the new one.
enum class ExistingOutput {
  keep,     ///< throw Error of kind output_exists
  replace,  ///< remove the existing output once the new one is complete
};

/// Returns whether the path is a device or pipe: it has no "final name" to protect and is written
/// directly.
bool is_stream(const std::filesystem::path& path);

/// Throws Error of kind output_exists when `write_file` would, so that a conflict is found before
/// any of several files is written.
void require_no_conflict(const std::filesystem::path& path, std::string_view bytes,
                         ExistingOutput existing);

/// Writes a file that appears under its name only when it is complete (until then it is
/// `.<name>.partial-<process>` beside it). An existing file with the same bytes is left alone; of a
/// symbolic link, the target is written. Throws Error: `temporary` when the disk is full, `input`
/// when the place cannot be written.
void write_file(const std::filesystem::path& path, std::string_view bytes,
                ExistingOutput existing = ExistingOutput::keep);

/// Writes each file into `folder` as `write_file` does, and makes the folders that hold it.
void write_files(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                 ExistingOutput existing = ExistingOutput::keep);

/// Throws Error unless a file could be made at `path`, so that a mistyped output is reported before
/// the work and not after it. Creates nothing.
void require_writable(const std::filesystem::path& path);

/// Throws Error unless a folder of results may be put at `path`: nothing is there, or an empty
/// folder, or (with `replace`) one that holds `marker`, a file that every folder of its kind has. A
/// folder that somebody else made is never replaced.
void require_replaceable(const std::filesystem::path& path, const std::string& marker,
                         ExistingOutput existing);

/// A folder that appears under its name only when it is complete: it is filled as
/// `.<name>.partial-<process>` beside that name and renamed by `commit`. The destructor removes a
/// folder that was not committed.
class OutputFolder {
 public:
  /// Makes the partial folder; `marker` is the file that `require_replaceable` looks for. Throws
  /// Error if the folder cannot be made.
  OutputFolder(const std::filesystem::path& path, std::string marker, ExistingOutput existing);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;

  const std::filesystem::path& partial() const { return partial_; }  ///< folder to write into

  /// Renames the partial folder to its final name, which must be free as `require_replaceable`
  /// demands. An existing folder with equal files is left alone.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path partial_;
  std::string marker_;
  ExistingOutput existing_;
};

/// A folder that several runs fill, at once or one after the other: it is `<name>.part` beside its
/// final name until `commit`, and stays there when a run ends early. A file in it, the marker, says
/// what it is being filled with; only runs with equal markers share it.
class StagedFolder {
 public:
  /// Makes the folder, or joins one with an equal marker. One with another marker is begun anew
  /// with `replace`; with `keep` it is an Error of kind output_exists.
  StagedFolder(const std::filesystem::path& path, const NamedBytes& marker,
               ExistingOutput existing);

  static std::filesystem::path staging_of(const std::filesystem::path& path);

  const std::filesystem::path& staging() const { return staging_; }  ///< folder to write into

  /// Removes files that killed runs left unfinished and renames the folder to its final name, which
  /// must be free as `require_replaceable` demands.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path staging_;
  std::string marker_name_;
  ExistingOutput existing_;
};

}  // namespace vo
