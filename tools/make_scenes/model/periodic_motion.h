#pragma once

#include <functional>

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// The times at which a motion that repeats itself is written down.
struct Period {
  double duration = 1;  ///< s
  int steps = 20;       ///< intervals between keys, of equal duration
};

/// Returns the motion of `node` over one period, given its pose at each phase from 0 to 2 pi.
Motion periodic_motion(int node, const Period& period,
                       const std::function<Eigen::Isometry3d(double phase)>& T_parent_node);

}  // namespace scenes
