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

/// A Durability says whether an output is on the disk, and not only in the system's memory, before
/// it has its name.
enum class Durability {
  synced,   ///< fsync of files and folders, before and after the rename: survives a loss of power
  unsynced  ///< a loss of power soon after may leave a file empty
};

/// How an output is put in its place.
struct OutputPolicy {
  // NOLINTNEXTLINE(google-explicit-constructor): what to do with an output there is all most say
  constexpr OutputPolicy(ExistingOutput what_is_there = ExistingOutput::keep,
                         Durability how_durable = Durability::synced,
                         void (*while_waiting)() = nullptr)
      : existing(what_is_there), durability(how_durable), waiting(while_waiting) {}

  ExistingOutput existing;
  Durability durability;
  void (*waiting)();  ///< called while others write the output or a pipe has no reader or room; may
                      ///< throw to give up; nullptr is not called
};

/// The path of this process' stdout, which `write_file` writes as it is, without opening it anew.
inline constexpr const char* kStdoutPath = "/dev/stdout";

/// Returns whether the path is a device, a pipe or an open descriptor (/dev/stdout, /dev/fd/3): it
/// has no "final name" to protect and is written directly. Files in /dev/shm are files.
bool is_stream(const std::filesystem::path& path);

/// Throws Error of kind output_exists when `write_file` would, so that a conflict is found before
/// any of several files is written.
void require_no_conflict(const std::filesystem::path& path, std::string_view bytes,
                         ExistingOutput existing);

/// Writes a file that appears under its name only when it is complete; until then it is a
/// PartialFile beside it, which a killed process leaves to the next that writes the file. An
/// existing file with the same bytes is left alone; of a symbolic link, the target is written.
/// Throws Error: `temporary` when the disk is full, `input` when the place cannot be written.
void write_file(const std::filesystem::path& path, std::string_view bytes,
                const OutputPolicy& policy = {});

/// Writes each file into `folder` as `write_file` does, and makes the folders that hold it.
void write_files(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                 const OutputPolicy& policy = {});

/// Throws Error unless a file could be made at `path`, so that a mistyped output is reported before
/// the work and not after it. Creates nothing.
void require_writable(const std::filesystem::path& path);

/// Returns the absolute path without dots, links or a slash at its end; of a link to what is not
/// there yet, its target.
std::filesystem::path resolved_output(const std::filesystem::path& path);

/// Throws Error of kind output_exists, which names `--force`.
[[noreturn]] void fail_to_replace(const std::filesystem::path& path);

}  // namespace vo
