#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "vo/core/progress.h"

namespace vo {

/// The greatest sizes of files that come from outside, bytes; what is larger is not read.
inline constexpr std::uintmax_t kMaxFileBytes = 4'000'000'000;
inline constexpr std::uintmax_t kMaxListBytes = 1'000'000'000;
inline constexpr std::uintmax_t kMaxDocumentBytes = 200'000'000;
inline constexpr std::uintmax_t kMaxConfigurationBytes = 16'000'000;

/// The path of this process' stdin, which `read_file` takes where it is a regular file.
inline constexpr const char* kStdinPath = "/dev/stdin";

/// Returns the whole file as bytes. Throws Error naming the path: `input` if it is no regular file
/// (a folder, a pipe, a device), is larger than `max_bytes` or cannot be read; `temporary` if there
/// is not enough memory for it. It never waits for a pipe's other end.
std::string read_file(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// Copies all that an open stream (a pipe, a terminal, a file) gives until its end into another
/// descriptor. `waiting` is called before each read and ten times a second while nothing comes.
/// Throws Error naming the stream `name`: `input` if it gives more than `max_bytes` or cannot be
/// read, `temporary` if there is no room for it.
void copy_stream(int from, int to, const std::string& name, std::uintmax_t max_bytes,
                 const WaitObserver& waiting);

/// Returns whether the symbolic links on the way from `folder` to `relative`, a path without "..",
/// lead to a place outside the folder, be it the first or one behind it.
bool leads_out(const std::filesystem::path& folder, const std::filesystem::path& relative);

/// Returns the path of a file that a list in `folder` names. Throws Error beginning with `place`,
/// the line of the list, if the name leads out of the folder, by itself or by a symbolic link.
std::filesystem::path path_in(const std::filesystem::path& folder, const std::string& name,
                              const std::string& place);

}  // namespace vo
