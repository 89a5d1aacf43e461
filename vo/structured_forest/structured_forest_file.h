#pragma once

#include <filesystem>
#include <string>

#include "vo/structured_forest/structured_forest.h"

namespace vo {

/// Reads a model in the format of OpenCV's ximgproc::createStructuredEdgeDetection: .yml, .xml or
/// .json, and each with .gz, told apart by content. Throws Error naming the file, the element and
/// what was expected; files of more than 500 MB, packed or not, are refused.
StructuredForest read_structured_forest(const std::filesystem::path& path);

/// Returns a forest as the text of a .yml file that `read_structured_forest` reads.
std::string structured_forest_yaml(const StructuredForest& forest);

}  // namespace vo
