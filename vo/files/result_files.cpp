#include "vo/files/result_files.h"

#include <system_error>

#include "vo/core/error.h"

namespace vo {

void write_results(const std::filesystem::path& folder, const std::vector<NamedBytes>& files,
                   ExistingOutput existing) {
  for (const auto& [name, bytes] : files) {
    require_no_conflict(folder / name, bytes, existing);
  }
  write_files(folder, files, existing);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  require(!error, folder.string(), ": cannot be made: ", error.message());
}

}  // namespace vo
