#pragma once

#include <memory>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"

namespace synth {

/// Makes a ray tracer of a static scene, which must outlive it. Depth is exact to the rounding of a
/// float: rays find the triangle in single precision and meet its plane in double. Colour is what
/// RenderOptions::mode says.
std::unique_ptr<Renderer> make_ray_tracer(const Scene& scene, const RenderOptions& options);

/// Makes a ray tracer of a moving scene, which must outlive it. Each ray meets geometry as it is at
/// the ray's own instant; lights stay as they are at SceneDuring::now.
std::unique_ptr<Renderer> make_ray_tracer(const SceneDuring& during, const RenderOptions& options);

}  // namespace synth
