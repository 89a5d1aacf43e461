#pragma once

#include <string>

#include "synth/gltf/gltf.h"
#include "synth/scene/scene.h"

namespace synth {

/// Returns whether a `GltfOptions::environment` names a file; otherwise it is none, or a sky.
bool is_environment_file(const std::string& environment);

/// Returns the light from all sides that options ask for: `sky:ELEVATION` or
/// `sky:ELEVATION,TURBIDITY`, deg, a clear sky with the sun towards -z; or an image's file, .hdr.
/// Throws vo::Error naming the file or the sky.
Environment read_environment(const GltfOptions& options);

}  // namespace synth
