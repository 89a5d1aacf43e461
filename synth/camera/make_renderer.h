#pragma once

#include <memory>
#include <string>
#include <vector>

#include "synth/rendering/capture.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/scene_motion.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// Creates the renderer of `options.kind` for a scene, which must outlive it. Throws vo::Error for
/// options out of their ranges.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const RenderOptions& options);

/// Creates a renderer of a moving scene, which must outlive it. The ray tracer moves geometry
/// within a capture and keeps lights as in `during.now`; the rasterizer keeps all as in
/// `during.now`.
std::unique_ptr<Renderer> make_renderer(const SceneDuring& during, const RenderOptions& options);

/// Throws vo::Error that says what of a scene a renderer with these options cannot draw, as the
/// renderer does when it is made.
void require_drawable(const Scene& scene, const RenderOptions& options);

/// Throws vo::Error that says what of a camera's lens and shutter a renderer with these options
/// cannot draw, as the renderer does when it renders.
void require_drawable(const vo::CameraModel& camera, const Shutter& shutter,
                      const RenderOptions& options);

/// Returns notes on what a renderer with these options does not draw of a scene's materials; one
/// sentence each.
std::vector<std::string> notes_on_materials(const Scene& scene, const RenderOptions& options);

}  // namespace synth
