#pragma once

#include <memory>

#include "synth/rendering/capture.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// Makes a renderer that draws with OpenGL on the CPU: far cheaper per frame than ray tracing if
/// colour needs few samples, and an independent check. Differs from the ray tracer in that
/// - lights cast no shadows;
/// - blended surfaces are drawn in the fraction of a pixel's samples that their alpha gives;
/// - it refuses scenes, lenses and shutters that are not `require_rasterizable`.
/// Frames are drawn one after another, each by all threads of Mesa's llvmpipe.
std::unique_ptr<Renderer> make_rasterizer(const Scene& scene, const RenderOptions& options);

/// Throws vo::Error if the rasterizer cannot draw a scene: one with light from all sides
/// (Scene::environment), or with more than 64 lights.
void require_rasterizable(const Scene& scene);

/// Throws vo::Error unless the rasterizer can draw what a camera sees: that of a pinhole without
/// distortion whose shutter is instant and global.
void require_rasterizable(const vo::CameraModel& camera, const Shutter& shutter);

}  // namespace synth
