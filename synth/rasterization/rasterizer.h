#pragma once

#include <memory>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"

namespace synth {

/// Makes a renderer that draws with OpenGL on the CPU: far cheaper per frame than ray tracing if
/// colour needs few samples, and an independent check. Differs from the ray tracer in that
/// - lights cast no shadows;
/// - blended surfaces are drawn in the fraction of a pixel's samples that their alpha gives;
/// - the lens must not distort, and the shutter must be instant and global, else vo::Error.
/// Frames are drawn one after another, each by all threads of Mesa's llvmpipe.
std::unique_ptr<Renderer> make_rasterizer(const Scene& scene, const RenderOptions& options);

}  // namespace synth
