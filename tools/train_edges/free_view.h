#pragma once

#include <optional>

#include "synth/ray_tracing/surface_tracer.h"
#include "vo/core/random.h"

namespace tools {

/// Returns a random T_world_camera indoors and outside of furniture: in the horizontal directions
/// and below there are surfaces, all at least 0.3 m away. It is empty when no such pose is found in
/// 20000 tries.
std::optional<vo::SE3> free_view(const synth::SurfaceTracer& tracer,
                                 const vo::PinholeCamera& camera, vo::Random& random);

}  // namespace tools
