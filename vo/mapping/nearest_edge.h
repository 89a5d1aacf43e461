#pragma once

#include "vo/mapping/hypotheses.h"
#include "vo/mapping/moved_edges.h"

namespace vo {

/// Returns the index of the nearest edge pixel of a similar direction within a pixel across its
/// edge, or -1.
int nearest_edge(const Hypotheses& hypotheses, const MovedEdge& moved);

}  // namespace vo
