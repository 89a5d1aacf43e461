#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// Where a level-headed camera looks.
struct PlannedView {
  double yaw = 0;    ///< rad, of the optical axis, from +x towards +z
  double pitch = 0;  ///< rad, upwards

  Eigen::Vector3d direction() const;  ///< unit, world
};

struct GazeLimits {
  double reach = 0;     ///< m, beyond which a surface counts for nothing
  double max_turn = 0;  ///< rad from one place to the next
};

/// One view for each place, each turned by at most `max_turn` from the one before it (as a change
/// of yaw and pitch together), so that the views hold as much texture in reach as can be had in
/// all; of equal ones those along the way. Yaws are continuous, not wrapped.
std::vector<PlannedView> plan_views(const SurfaceTracer& tracer,
                                    const std::vector<Eigen::Vector3d>& places,
                                    const GazeLimits& limits);

/// The least `max_turn` with which the camera can turn at all, rad.
double least_turn();

}  // namespace synth
