#pragma once

#include <cstdint>

#include "synth/path/camera_path.h"
#include "synth/ray_tracing/surface_tracer.h"

namespace synth {

/// The limits of a camera path that is planned automatically. A value of 0 is chosen by the scene's
/// scale: the typical distance from a camera to what it sees.
struct ExploreOptions {
  double length = 0;     ///< m, greatest length; 0 = what the duration allows
  double speed = 0;      ///< m/s, greatest speed; 0 = a fifth of the scale a second
  double clearance = 0;  ///< m, least distance to surfaces; 0 = a tenth of the scale
  double turn_deg = 40;  ///< deg/s, greatest angular speed
  std::uint64_t seed = 0;

  void validate() const;  ///< throws vo::Error if out of range
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
  double duration = 0;   ///< s, time from rest to rest
  double speed = 0;      ///< m/s, upper bound of the speed
  double clearance = 0;  ///< m, least distance to surfaces along the path
};

/// Plans a path along a roadmap of the scene's free space, indoors if there is an inside, smoothed
/// as far as the clearance allows. It looks where much textured surface is in reach, by dynamic
/// programming over small renders. `duration_s` counts where no length is asked for. The result is
/// a pure function of the arguments. Throws vo::Error where there is no free space.
ExploredPath explore(const SurfaceTracer& tracer, double duration_s, const ExploreOptions& options);

}  // namespace synth
