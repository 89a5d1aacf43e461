#pragma once

#include <memory>

#include "vo/image/edge_points.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// Whether hypotheses of which nothing is known count.
enum class Guesses { left_out, included };

/// The hypotheses whose relative standard deviation is at most `max_sigma`, as the tracker takes
/// them: on coarser levels every pixel that has one below it, at the nearest of their depths.
EdgePoints map_points(const FramePyramid& anchor, const Hypotheses& hypotheses,
                      const EdgePointOptions& options, double max_sigma, Guesses guesses);

}  // namespace vo
