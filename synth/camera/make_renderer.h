#pragma once

#include <memory>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"

namespace synth {

/// The renderer of `options.kind` for a scene, which must outlive it. Throws vo::Error for options
/// out of their ranges.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const RenderOptions& options);

/// The ray tracer has moving things move while a capture is taken; lights stay as they are `now`.
/// The rasterizer, which takes captures of an instant alone, has all things as they are `now`.
std::unique_ptr<Renderer> make_renderer(const SceneDuring& during, const RenderOptions& options);

}  // namespace synth
