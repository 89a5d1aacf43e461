#pragma once

#include "vo/mapping/depth_map_options.h"
#include "vo/mapping/hypotheses.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {

/// What became of the hypotheses of one host in the next.
struct PropagationCounts {
  std::size_t moved = 0;
  std::size_t merged = 0;    ///< two that met and agreed
  std::size_t occluded = 0;  ///< two that met and did not: the farther, or another intensity
  std::size_t out_of_view = 0;
  std::size_t without_edge = 0;  ///< no edge of its direction within a pixel
};

/// Depth and variance of a point of inverse depth d after the camera moved (Engel, Sturm, Cremers,
/// ICCV 2013, Eq. 14 with the scale of sigma relative): the point's ray is R ray + d t over d.
struct MovedDepth {
  float inverse_depth = 0;  ///< 1/m; 0 behind the camera
  float variance = 0;       ///< 1/m^2
  Eigen::Vector2f ray{0, 0};
};

MovedDepth moved_depth(const StereoPair& pair, const Eigen::Vector2f& ray, float inverse_depth,
                       float variance, float relative_noise);

/// Carries what is known to the edges of the pair's current image, whose fresh hypotheses are
/// `next`. Each hypothesis snaps to the nearest edge of its direction.
PropagationCounts propagate(const StereoPair& pair, const Hypotheses& hypotheses,
                            const DepthMapOptions& options, Hypotheses& next);

}  // namespace vo
