#include "tools/processes/scratch_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "vo/core/error.h"

namespace tools {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "edvo-XXXXXX").string();
  vo::require(mkdtemp(name.data()) != nullptr, name, ": cannot be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tools
