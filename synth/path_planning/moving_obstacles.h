#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/scene/scene.h"

namespace synth {

/// A scene at rest: the moving scene at time 0 and, once more, its moving things at every quarter
/// of a second up to `duration`, s, or the end of the animations. What keeps clear of it keeps
/// clear of all places where things come by.
Scene with_traces(const Scene& scene, double duration);

/// A straight step in the time between two states of a moving scene.
struct TimedStep {
  Eigen::Vector3d from;  ///< m, world
  Eigen::Vector3d to;
};

/// Whether one of the moving instances meets a point that takes the step while the scene goes from
/// the one state to the other; each sees the point go straight. Exact for what does not bend.
bool is_struck(const Scene& before, const Scene& after, const std::vector<bool>& moving,
               const TimedStep& step);

}  // namespace synth
