#pragma once

#include <cerrno>
#include <filesystem>
#include <string_view>

#include "vo/core/error.h"

namespace vo {

/// Returns the kind of failure that an `errno` stands for: `temporary` where the same call may
/// succeed once others have given back what is scarce (space on the disk, descriptors, memory),
/// else `input`.
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
