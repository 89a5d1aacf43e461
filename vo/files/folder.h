#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vo {

enum class EntryKind { file, folder, link, other };

/// A file, folder, symbolic link (which is not followed) or else that lies in a folder.
struct FolderEntry {
  std::string name;  ///< within the folder, with `/` between the parts
  EntryKind kind;
};

/// Returns what lies in a folder, sorted by name. Throws Error naming the folder where it cannot be
/// read, and std::bad_alloc where memory ends: the iterators of libstdc++ 12 to 14 end the program
/// then.
std::vector<FolderEntry> entries_of(const std::filesystem::path& folder);

/// Returns what lies in a folder and in the folders below it, each folder before what it holds.
/// Throws as `entries_of` does.
std::vector<FolderEntry> entries_below(const std::filesystem::path& folder);

/// Removes a file, or a folder and all below it. Returns 0, also where there is nothing, or the
/// `errno` of what cannot be removed.
int remove_tree(const std::filesystem::path& path) noexcept;

/// Removes as `remove_tree` does. Throws Error naming the path where that fails.
void remove_completely(const std::filesystem::path& path);

/// Gives a file or folder another name, in place of a file, or of an empty folder, that has it.
/// Throws Error naming `to` where that fails.
void rename_entry(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace vo
