#pragma once

#include <memory>
#include <string>
#include <vector>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"

namespace synth {

/// Creates the renderer of `options.kind` for a scene, which must outlive it. Throws vo::Error for
/// options out of their ranges.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const RenderOptions& options);

/// Creates a renderer of a moving scene, which must outlive it. The ray tracer moves geometry
/// within a capture and keeps lights as in `during.now`; the rasterizer keeps all as in
/// `during.now`.
std::unique_ptr<Renderer> make_renderer(const SceneDuring& during, const RenderOptions& options);

/// Returns notes on what a renderer with these options does not draw of a scene's materials; one
/// sentence each.
std::vector<std::string> notes_on_materials(const Scene& scene, const RenderOptions& options);

}  // namespace synth
