#pragma once

#include <filesystem>
#include <vector>

#include "vo/files/output.h"

namespace vo {

/// Writes all files into the folder, or none and throws Error when one of them would replace
/// another result.
void write_results(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                   const OutputPolicy& policy);

/// Makes the folder and its parents; throws vo::Error when that fails.
void make_folder(const std::filesystem::path& folder);

/// A folder for results that take long: it is made before they are, so that a place where it cannot
/// be is told at once. The destructor removes what the constructor made and nothing was written
/// into.
class FolderForResults {
 public:
  /// Makes the folder and its parents; throws vo::Error when that fails.
  explicit FolderForResults(const std::filesystem::path& folder);
  ~FolderForResults();
  FolderForResults(const FolderForResults&) = delete;
  FolderForResults& operator=(const FolderForResults&) = delete;
  FolderForResults(FolderForResults&&) = delete;
  FolderForResults& operator=(FolderForResults&&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< innermost first
};

}  // namespace vo
