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

/// What to do when the output is there already and is not the same.
enum class ExistingOutput {
  keep,     ///< Error of kind output_exists
  replace,  ///< what was there is gone once the new output is complete
};

/// A device or pipe: it has no "final name" to protect and is written directly.
bool is_stream(const std::filesystem::path& path);

/// Throws Error of kind output_exists when `write_file` would: to find out before any of several
/// files is written.
void require_no_conflict(const std::filesystem::path& path, std::string_view bytes,
                         ExistingOutput existing);

/// Writes a file that appears under its name only when it is complete (until then it is
/// `.<name>.partial-<process>` beside it). An existing file with the same bytes is left alone; of a
/// symbolic link, the target is written. Throws Error: `temporary` when the disk is full, `input`
/// when the place cannot be written.
void write_file(const std::filesystem::path& path, std::string_view bytes,
                ExistingOutput existing = ExistingOutput::keep);

/// The whole file as bytes; throws Error naming the path.
std::string read_file(const std::filesystem::path& path);

/// Makes the folders within `folder` that files of these names lie in.
void make_folders_of(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Throws Error unless a file could be made at `path`, so that a mistyped output is reported before
/// the work and not after it. Makes nothing.
void require_writable(const std::filesystem::path& path);

/// Throws Error unless a folder of results may be put at `path`: nothing is there, or an empty
/// folder, or (with `replace`) one that holds `marker`, a file that every folder of its kind has. A
/// folder that somebody else made is never replaced.
void require_replaceable(const std::filesystem::path& path, const std::string& marker,
                         ExistingOutput existing);

/// A folder that appears under its name only when it is complete: it is filled as
/// `.<name>.partial-<process>` beside it and renamed by `commit`; without it, the destructor
/// removes it again.
class OutputFolder {
 public:
  /// `marker` as in `require_replaceable`.
  OutputFolder(const std::filesystem::path& path, std::string marker, ExistingOutput existing);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;

  const std::filesystem::path& partial() const { return partial_; }  ///< write here

  /// An existing folder with the same files is left alone; otherwise as `require_replaceable`.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path partial_;
  std::string marker_;
  ExistingOutput existing_;
};

/// A folder that several runs fill, at once or one after the other: it is `<name>.part` beside its
/// final name until `commit`, and stays there when a run ends early. A file in it, the marker, says
/// what it is being filled with; only runs with the same marker share it.
class StagedFolder {
 public:
  /// Makes the folder, or joins it. One with another marker is begun anew with `replace`; with
  /// `keep` it is an Error of kind output_exists.
  StagedFolder(const std::filesystem::path& path, const NamedBytes& marker,
               ExistingOutput existing);

  static std::filesystem::path staging_of(const std::filesystem::path& path);

  const std::filesystem::path& staging() const { return staging_; }  ///< write here

  /// Puts it under its final name, as `require_replaceable` allows, without what runs that were
  /// killed left unfinished.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path staging_;
  std::string marker_name_;
  ExistingOutput existing_;
};

}  // namespace vo
