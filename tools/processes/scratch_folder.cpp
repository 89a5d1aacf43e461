#include "tools/processes/scratch_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "vo/core/error.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

/// Lets the owner write into all folders below, without which what is in them cannot be removed.
void make_writable(const fs::path& folder) {
  std::error_code ignored;
  for (fs::recursive_directory_iterator entry(folder, ignored), end; entry != end;
       entry.increment(ignored)) {
    if (entry->symlink_status(ignored).type() == fs::file_type::directory) {
      fs::permissions(entry->path(), fs::perms::owner_all, fs::perm_options::add, ignored);
    }
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "edvo-XXXXXX").string();
  vo::require(mkdtemp(name.data()) != nullptr, name, ": cannot be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  make_writable(path_);
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tools
