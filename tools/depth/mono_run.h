#pragma once

#include <map>
#include <optional>
#include <vector>

#include "tools/depth/mapping_run.h"
#include "vo/sequence_odometry/track_mono.h"

namespace tools {

/// Compares the map of a monocular run with the true depth of its host. Unless the bootstrap is
/// metric, each frame's map is divided by its median scale first; that scale over time shows its
/// drift.
class MapJudge {
 public:
  /// `truth` must outlive the judge; its depth images are the ground truth, but for the standard
  /// deviation of inverse depth, 1/m, that is given.
  MapJudge(const vo::SequenceReader& truth, vo::MonoBootstrap bootstrap, double depth_noise = 0);

  /// Returns the map's errors; empty while not tracking or without a depth image of the host.
  std::optional<MappedFrame> judge(const vo::MonoOdometry& odometry, const vo::MonoResult& result);

  const vo::DepthImage& true_depth() const { return host_.depth; }  ///< true depth of the last host

 private:
  void read_truth(double timestamp);

  const vo::SequenceReader& truth_;
  bool is_metric_;
  double depth_noise_;
  std::map<double, std::size_t> index_of_;  ///< frame index by image timestamp
  double timestamp_ = -1;
  TrueView host_;
};

/// Tracks and maps a sequence as `edvo track --mode mono` does and evaluates each map with its
/// depth images, whose inverse depths have that standard deviation, 1/m.
std::vector<MappedFrame> track_and_judge(const vo::MonoInput& input, const vo::MonoOptions& options,
                                         double depth_noise, const MapObserver& observe,
                                         const vo::Progress& progress);

}  // namespace tools
