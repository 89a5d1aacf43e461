#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/depth/edge_truth.h"
#include "vo/mapping/depth_map.h"

namespace tools {

/// Kind of edge that a hypothesis lies on, judged by the true depth around it.
enum class EdgeKind { surface, depth_step };

/// One depth hypothesis compared with the truth.
struct DepthSample {
  double ratio = 1;             ///< estimated over true inverse depth
  double normalized_error = 0;  ///< difference of inverse depth over its standard deviation
  double angle_deg = 0;         ///< angle between gradient and epipolar line, 0..90 deg
  bool is_confident = false;
  EdgeKind kind = EdgeKind::surface;
  std::uint8_t causes = 0;  ///< bits of synth::EdgeCause within 1 px; 0 if unknown
};

/// Errors of a subset of a map's hypotheses; NaN if it is empty.
struct DepthErrors {
  std::size_t count = 0;
  double median_percent = 0;  ///< median |relative error| of the inverse depth
  double p90_percent = 0;
  double outliers_percent = 0;  ///< share with a relative error beyond 10 %
  double nees = 0;              ///< NEES: mean squared normalised error of the inliers
};

/// A map's errors against its host's true depth, taken as the best value in a 3x3 window, because
/// an edge between a near and a far surface belongs to the near one.
struct MapErrors {
  DepthErrors confident;
  DepthErrors all;                      ///< every hypothesis with an estimate
  DepthErrors surface;                  ///< confident, not at a step of the true depth
  DepthErrors depth_step;               ///< confident, at a step of the true depth
  std::array<DepthErrors, 4> by_cause;  ///< confident, by synth::EdgeCause; causes overlap
  DepthErrors without_cause;            ///< confident, without a cause although causes are known
  std::array<DepthErrors, 3> by_angle;  ///< confident, by angle: 0-30, 30-60, 60-90 deg
  double density_percent = 0;           ///< share of hypotheses that are confident
  double scale = 1;                     ///< median of estimated over true inverse depth, confident
};

/// Returns a sample for every hypothesis that has an estimate and a true depth; the epipolar lines
/// are those of the relation. Estimates are divided by `scale` first.
std::vector<DepthSample> depth_samples(const vo::DepthMap& map, const TrueView& truth,
                                       const vo::FrameRelation& relation, double scale);

/// Returns the map's errors after dividing the estimates by `host_scale`: 1 for a metric map; 0
/// takes the median scale found.
MapErrors map_errors(const vo::DepthMap& map, const TrueView& truth,
                     const vo::FrameRelation& relation, double host_scale = 1);

}  // namespace tools
