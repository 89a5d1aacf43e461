#pragma once

#include <filesystem>
#include <vector>

namespace tools {

/// What a child process sees of the file system, where it is permitted to have a view of its own (a
/// mount namespace, which needs CAP_SYS_ADMIN).
struct PrivateView {
  std::vector<std::filesystem::path> read_only;  ///< folders that cannot be written
  std::vector<std::filesystem::path> hidden;     ///< folders that appear empty
};

/// Gives this process and its later children the view. Does nothing where that is not permitted.
/// Calls only functions that are safe between fork and exec.
void enter_view(const PrivateView& view);

}  // namespace tools
