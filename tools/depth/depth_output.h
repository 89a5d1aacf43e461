#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tools/depth/mapping_run.h"
#include "tools/point_cloud/point_cloud.h"
#include "vo/output_folders/output_folder.h"

namespace tools {

/// States whether a map is metric or of arbitrary scale, which is removed before it is drawn.
enum class MapScale { metric, arbitrary };

/// Returns the scale that a map is divided by before it is compared with the truth.
double divisor(const vo::DepthMap& map, const vo::DepthImage& true_depth, MapScale scale);

/// Writes a folder with depth.csv, course.svg, a picture of every n-th frame and the points of
/// the last one pictured as cloud.ply and cloud.pcd. The folder appears when committed.
class DepthOutput {
 public:
  /// Begins the folder, having waited for others that make it; `every` 0 writes no picture.
  DepthOutput(const std::filesystem::path& folder, int every, const vo::OutputPolicy& policy,
              const vo::WaitObserver& waiting);

  MapObserver observer(MapScale scale);  ///< callback that draws maps; refers to this output
  void commit(const std::vector<MappedFrame>& frames);

 private:
  int every_;
  vo::OutputFolder folder_;
  std::optional<EdgeCloud> cloud_;  ///< of the last map that was pictured
};

}  // namespace tools
