#include "vo/files/result_files.h"

#include <system_error>

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

}  // namespace vo
