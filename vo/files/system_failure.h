#pragma once

#include <cerrno>
#include <filesystem>
#include <string_view>

#include "vo/core/error.h"

namespace vo {

/// Returns the kind of failure that an `errno` stands for: `temporary` where the machine failed, so
/// that the same call may succeed later (no space on the disk, no descriptors, memory or locks, a
/// device that cannot be read or written), else `input`: what was asked for cannot be had.
ErrorKind kind_of_failure(int error);

/// Throws Error `<path>: <what>: <the system's text for error>`, of the kind of the failure.
[[noreturn]] void fail_with(const std::filesystem::path& path, std::string_view what, int error);

/// Calls a system call until no signal interrupts it; returns its result.
template <typename Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result < 0 && errno == EINTR) {
    result = call();
  }
  return result;
}

}  // namespace vo
