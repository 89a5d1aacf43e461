#include "tools/datasets/parts/archive_names.h"

#include <filesystem>

namespace tools {

std::string archive_name(const std::string& sequence, const std::string& camera,
                         const std::string& file) {
  const std::filesystem::path path(file);
  return sequence + "/" + path.stem().string() + "." + (camera.empty() ? "" : camera + ".") +
         path.parent_path().filename().string() + path.extension().string();
}

}  // namespace tools
