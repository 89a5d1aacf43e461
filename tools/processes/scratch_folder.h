#pragma once

#include <filesystem>
#include <optional>

#include "vo/files/file_lock.h"

namespace tools {

/// A temporary folder that is removed by the destructor with its contents, read-only folders
/// included. It is `edvo-XXXXXX` in the system's folder for such, beside a file `edvo-XXXXXX.lock`
/// that is locked while the folder is in use, so that the next to make one removes what killed
/// processes left.
class ScratchFolder {
 public:
  ScratchFolder();  ///< throws vo::Error if the folder cannot be made
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::filesystem::path lock_file_;
  std::optional<vo::FileLock> lock_;
};

}  // namespace tools
