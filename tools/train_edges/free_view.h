#pragma once

#include <optional>

#include "synth/ray_tracing/surface_tracer.h"
#include "vo/core/random.h"

namespace tools {

/// A random T_world_camera that looks at something from a place that is indoors and not inside
/// furniture: to all sides and below there is a surface, none nearer than 0.3 m. Nothing when
/// thousands of tries have found none.
std::optional<vo::SE3> free_view(const synth::SurfaceTracer& tracer,
                                 const vo::PinholeCamera& camera, vo::Random& random);

}  // namespace tools
