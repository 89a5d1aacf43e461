#pragma once

#include <cstdint>

#include "synth/scene/scene.h"

namespace synth {

/// Returns a hash of the scene's content, equal for equal scenes whatever files they came from.
std::uint64_t content_hash(const Scene& scene);

}  // namespace synth
