#pragma once

#include <memory>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"

namespace synth {

/// Draws with OpenGL on the processor: far cheaper per frame than rays where colour needs few
/// samples, and a second opinion. Differs from the ray tracer in that
/// - lights cast no shadows;
/// - blended surfaces are drawn in the share of a pixel's samples that their alpha says;
/// - the lens must not distort, and the shutter must be instant and global: else vo::Error.
/// Frames are drawn one after the other, each by all threads of Mesa's llvmpipe.
std::unique_ptr<Renderer> make_rasterizer(const Scene& scene, const RenderOptions& options);

}  // namespace synth
