#pragma once

namespace synth {

/// The images without which a file is not read; others may be missing: all; those of surfaces,
/// without light from all sides, as the rasterizer needs; those of the base colour; or those of the
/// base colour of materials that are not opaque, as depth needs.
enum class NeededTextures { all, surfaces, base_color, alpha };

}  // namespace synth
