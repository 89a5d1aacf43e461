#pragma once

#include <memory>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"

namespace synth {

/// Depth is exact to the rounding of a float: rays find the triangle in single precision and meet
/// its plane in double. Colour is direct light with shadows on diffuse surfaces. The scene must
/// outlive the renderer.
std::unique_ptr<Renderer> make_ray_tracer(const Scene& scene, const RenderOptions& options);

/// Each ray meets moving things where they are at its own instant; lights stay as they are `now`.
std::unique_ptr<Renderer> make_ray_tracer(const SceneDuring& during, const RenderOptions& options);

}  // namespace synth
