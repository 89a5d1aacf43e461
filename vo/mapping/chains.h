#pragma once

#include "vo/mapping/depth_map_options.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// Smooths inverse depths along the edges: a line fitted through those neighbours within five
/// pixels along the chain that agree, weighted by inverse variance. The filters' own states stay
/// as they are, so nothing is counted twice.
void smooth_along_chains(Hypotheses& hypotheses);

/// Forgets hypotheses that disagree with neighbours that agree among themselves; how many.
std::size_t forget_lonely(const DepthMapOptions& options, float guess, Hypotheses& hypotheses);

/// Gives edge pixels of which nothing is known the mean of at least two neighbours within two
/// pixels that agree within 10 %; how many.
std::size_t fill_from_neighbours(const DepthMapOptions& options, Hypotheses& hypotheses);

}  // namespace vo
