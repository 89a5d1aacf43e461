#pragma once

#include "vo/mapping/hypotheses.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {

/// The number of a host's hypotheses by what happened to them at the change to the next host.
struct PropagationCounts {
  std::size_t moved = 0;
  std::size_t merged = 0;    ///< two at one pixel, in agreement
  std::size_t occluded = 0;  ///< behind another at one pixel, or of changed intensity
  std::size_t out_of_view = 0;
  std::size_t without_edge = 0;  ///< no edge of a similar direction within a pixel
};

/// A point's inverse depth and variance after the camera moved (Engel, Sturm, Cremers, ICCV 2013,
/// Eq. 14 with a relative sigma). With inverse depth d in the host it is at (R ray + d t) / d.
struct MovedDepth {
  float inverse_depth = 0;  ///< 1/m; 0 behind the camera
  float variance = 0;       ///< 1/m^2
  Eigen::Vector2f ray{0, 0};
};

MovedDepth moved_depth(const StereoPair& pair, const Eigen::Vector2f& ray, float inverse_depth,
                       float variance, float relative_noise);

/// Carries the known depths to the edges of the pair's current image, whose fresh hypotheses are
/// `next`. Each hypothesis snaps to the nearest edge of a similar direction.
PropagationCounts propagate(const StereoPair& pair, const Hypotheses& hypotheses, Hypotheses& next);

/// What another view shows of some of a host's edges, guesses included.
struct SeenEdges {
  double asked = 0;    ///< number of edges that were looked for
  double seen = 0;     ///< number of those that are in view
  double flow_px = 0;  ///< sum of the displacements of those in view
};

/// Looks for every `stride`-th edge at the depth that is known or guessed.
SeenEdges seen_edges(const StereoPair& pair, const Hypotheses& hypotheses, std::size_t stride);

}  // namespace vo
