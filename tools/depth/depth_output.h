#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/depth/mapping_run.h"
#include "vo/files/output.h"

namespace tools {

/// Whether a map's scale is that of the truth, or is taken out before it is drawn.
enum class MapScale { metric, arbitrary };

/// By what a map is divided before it is compared with the truth.
double divisor(const vo::DepthMap& map, const vo::DepthImage& true_depth, MapScale scale);

/// A folder of what a map looked like: depth.csv, a picture of every n-th frame, cloud.ply of the
/// last one pictured. It appears when all is there.
class DepthOutput {
 public:
  /// `every` 0 writes no picture.
  DepthOutput(const std::filesystem::path& folder, int every, vo::ExistingOutput existing);

  MapObserver observer(MapScale scale);  ///< refers to this output
  void commit(const std::vector<MappedFrame>& frames);

 private:
  int every_;
  vo::OutputFolder folder_;
  std::string cloud_;
};

}  // namespace tools
