#pragma once

#include <array>

#include "synth/denoising/planes.h"

namespace synth {

/// Returns the light of each half and channel, fitted around each pixel.
std::array<std::array<Plane, 3>, 2> fitted_light(const LightPlanes& planes);

}  // namespace synth
