#include "vo/files/result_files.h"

#include <system_error>

#include <unistd.h>

#include "vo/files/system_failure.h"

namespace vo {

void write_results(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                   const OutputPolicy& policy) {
  for (const auto& [name, bytes] : files) {
    require_no_conflict(folder / name, bytes, policy.existing);
  }
  write_files(folder, files, policy);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    fail_with(folder, "cannot be made", error.value());
  }
}

FolderForResults::FolderForResults(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::path place = std::filesystem::absolute(folder).lexically_normal();
       !std::filesystem::exists(place, error) && place.has_relative_path();
       place = place.parent_path()) {
    made_.push_back(place);
  }
  make_folder(folder);
}

FolderForResults::~FolderForResults() {
  for (const std::filesystem::path& folder : made_) {
    ::rmdir(folder.c_str());  // does nothing to one that holds something
  }
}

}  // namespace vo
