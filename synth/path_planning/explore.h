#pragma once

#include <cstdint>

#include "synth/path/camera_path.h"
#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// A camera that finds its own way. What is 0 is chosen by the scene's own scale: how far one
/// typically sees in it.
struct ExploreOptions {
  double length = 0;     ///< m at most; 0 = what the duration allows
  double speed = 0;      ///< m/s at most; 0 = a fifth of the scale a second
  double clearance = 0;  ///< m to everything, all along; 0 = a tenth of the scale
  double turn_deg = 40;  ///< deg/s at most
  std::uint64_t seed = 0;

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, ExploreOptions& options) {
  visit("length", options.length, "at most, m; 0 = what the duration allows");
  visit("speed", options.speed, "at most, m/s; 0 = by the scene's scale");
  visit("clearance", options.clearance, "to everything, all along, m; 0 = by the scene's scale");
  visit("turn_deg", options.turn_deg, "angular speed at most, deg/s");
  visit("seed", options.seed, "another seed is another way");
}

struct ExploredPath {
  CameraPath path;       ///< from rest to rest, twice continuously differentiable, never rolled
  double duration = 0;   ///< s
  double speed = 0;      ///< m/s, nowhere exceeded
  double clearance = 0;  ///< m, everywhere kept
};

/// Wanders along a roadmap of the scene's free space, inside of it if there is an inside, smoothed
/// as far as the clearance allows, and looks where much textured surface is in reach, found by
/// dynamic programming over small renders. `duration` counts where no length is asked for. A pure
/// function of its arguments. Throws vo::Error where there is no room.
ExploredPath explore(const SurfaceTracer& tracer, double duration_s, const ExploreOptions& options);

}  // namespace synth
