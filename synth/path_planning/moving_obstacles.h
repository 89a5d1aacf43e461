#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/scene/scene.h"

namespace synth {

/// Returns a static scene: the moving scene at time 0 with copies of its moving instances every
/// quarter of a second (at most 64 times, then less often) up to `duration`, s, or the end of the
/// animations. A path clear of it keeps clear of where moving instances are at those times.
Scene with_traces(const Scene& scene, double duration);

/// A point's straight step in the time between two states of a moving scene.
struct TimedStep {
  Eigen::Vector3d from;  ///< m, world, in the state before
  Eigen::Vector3d to;
};

/// Returns whether a moving instance hits a point that takes the step while the scene goes from
/// `before` to `after`. The point is taken to move straight in each mesh's frame; deformation is
/// ignored.
bool is_struck(const Scene& before, const Scene& after, const std::vector<bool>& moving,
               const TimedStep& step);

}  // namespace synth
