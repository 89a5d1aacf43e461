#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// The viewing direction of a camera without roll.
struct PlannedView {
  double yaw = 0;    ///< rad, of the optical axis, from +x towards +z
  double pitch = 0;  ///< rad, upwards

  Eigen::Vector3d direction() const;  ///< unit, world
};

struct GazeLimits {
  double reach = 0;     ///< m, distance beyond which a surface counts for nothing
  double max_turn = 0;  ///< rad, greatest turn from one place to the next
};

/// Returns one view for each place, each turned by at most `max_turn` from the one before it (yaw
/// and pitch together), so that the views see as much texture in reach as possible in all, with
/// small preferences for looking ahead and for turning little. Yaws are continuous, not wrapped.
std::vector<PlannedView> plan_views(const SurfaceTracer& tracer,
                                    const std::vector<Eigen::Vector3d>& places,
                                    const GazeLimits& limits);

/// Returns the least `max_turn` with which the camera can turn at all, rad.
double least_turn();

}  // namespace synth
