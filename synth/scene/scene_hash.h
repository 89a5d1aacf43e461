#pragma once

#include <string>

#include "synth/scene/scene.h"

namespace synth {

/// Returns a hash of the scene's content, equal for equal scenes whatever files they came from.
std::string content_hash(const Scene& scene);

}  // namespace synth
