#pragma once

#include <string>

#include "synth/scene/scene.h"

namespace synth {

/// Returns whether the name of an environment is that of a file; otherwise it is none, or a sky.
bool is_environment_file(const std::string& name);

/// Returns the light from all sides that a name stands for, not turned: `sky:ELEVATION` or
/// `sky:ELEVATION,TURBIDITY`, deg, a clear sky with the sun towards -z; or the file of an
/// equirectangular image, OpenEXR's where it ends with .exr and otherwise Radiance's (.hdr); none
/// for an empty name. Throws vo::Error naming the file or the sky.
Environment read_environment(const std::string& name);

}  // namespace synth
