#pragma once

#include <map>
#include <optional>
#include <vector>

#include "tools/depth/mapping_run.h"
#include "vo/odometry/track_mono.h"

namespace tools {

/// Whether the bootstrap's depths are metres.
bool is_metric(vo::MonoBootstrap bootstrap);

/// Compares the map of a monocular run with the true depth of its host. Where the bootstrap is
/// not metric, depths are divided by the median scale of each frame first; the scale over time
/// shows its drift.
class MapJudge {
 public:
  /// `truth` must outlive the judge; its depth images are taken for true.
  MapJudge(const vo::SequenceReader& truth, vo::MonoBootstrap bootstrap);

  /// Nothing while there is no map, and where its host has no depth image beside it.
  std::optional<MappedFrame> judge(const vo::MonoOdometry& odometry, const vo::MonoResult& result);

  const vo::DepthImage& true_depth() const { return host_.depth; }  ///< of the last host judged

 private:
  void read_truth(double timestamp);

  const vo::SequenceReader& truth_;
  bool is_metric_;
  std::map<double, std::size_t> index_of_;  ///< by the stamp of the image
  double timestamp_ = -1;
  TrueView host_;
};

/// Tracks and maps a sequence as `edvo track --mode mono` does and judges every map.
std::vector<MappedFrame> track_and_judge(const vo::MonoInput& input, const vo::MonoOptions& options,
                                         const MapObserver& observe, const vo::Progress& progress);

}  // namespace tools
