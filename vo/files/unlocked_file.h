#pragma once

#include <filesystem>
#include <string_view>

#include "vo/files/output.h"

namespace vo {

/// Writes a file that appears under its name only when it is complete, in place of one that is
/// there, without a lock: for folders that several machines write into, on file systems whose locks
/// do not reach from one to another. Of writers of the same file at once, each has a partial file
/// of its own, named as `partial_name` names one; the last rename wins. Throws Error as
/// `write_file` does.
void write_unlocked(const std::filesystem::path& path, std::string_view bytes,
                    Durability durability);

/// Removes what processes of this machine that were killed in `write_unlocked` left in a folder.
/// Throws Error where the folder cannot be read.
void remove_abandoned_unlocked(const std::filesystem::path& folder);

}  // namespace vo
