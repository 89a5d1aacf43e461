#pragma once

#include <filesystem>

namespace tools {

/// A temporary folder that is removed by the destructor with its contents, read-only folders
/// included.
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
};

}  // namespace tools
