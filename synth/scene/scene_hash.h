#pragma once

#include <cstdint>

#include "synth/scene/scene.h"

namespace synth {

/// Equal for equal scenes, whatever files they came from.
std::uint64_t content_hash(const Scene& scene);

}  // namespace synth
