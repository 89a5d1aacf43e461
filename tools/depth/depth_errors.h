#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/depth/edge_truth.h"
#include "vo/mapping/depth_map.h"

namespace tools {

/// What kind of edge a hypothesis lies on, by the true depth around it.
enum class EdgeKind { surface, depth_step };

/// One hypothesis beside the truth.
struct DepthSample {
  double ratio = 1;             ///< estimated over true inverse depth
  double normalized_error = 0;  ///< error over predicted standard deviation
  double angle_deg = 0;         ///< of gradient and epipolar line, 0 to 90
  bool is_confident = false;
  EdgeKind kind = EdgeKind::surface;
  std::uint8_t causes = 0;  ///< bits of synth::EdgeCause within a pixel, where they are known
};

/// Errors of some of a map's hypotheses.
struct DepthErrors {
  std::size_t count = 0;
  double median_percent = 0;  ///< |relative error of the inverse depth|
  double p90_percent = 0;
  double outliers_percent = 0;  ///< beyond 10 %
  double nees = 0;              ///< mean squared normalised error of those within 10 %
};

/// A map's errors against the true depth of its host: the best in a 3x3 window, because an edge
/// between a near and a far surface belongs to the near one.
struct MapErrors {
  DepthErrors confident;
  DepthErrors all;                      ///< of which anything is known
  DepthErrors surface;                  ///< confident, on texture and creases
  DepthErrors depth_step;               ///< confident, at a step of the true depth
  std::array<DepthErrors, 4> by_cause;  ///< confident, by synth::EdgeCause; edges may have several
  DepthErrors without_cause;            ///< confident, where causes are known and there is none
  std::array<DepthErrors, 3> by_angle;  ///< confident; 0-30, 30-60, 60-90 deg
  double density_percent = 0;           ///< confident hypotheses of all edge pixels kept
  double scale = 1;                     ///< median estimated over true inverse depth, confident
};

/// Every hypothesis of which something is known and the truth is; the epipolar lines are those of
/// the relation. Estimates are divided by `scale` first.
std::vector<DepthSample> depth_samples(const vo::DepthMap& map, const TrueView& truth,
                                       const vo::FrameRelation& relation, double scale);

/// `host_scale` 1 for a metric map; 0 divides by the median scale found.
MapErrors map_errors(const vo::DepthMap& map, const TrueView& truth,
                     const vo::FrameRelation& relation, double host_scale = 1);

}  // namespace tools
