#pragma once

#include "synth/sensor/depth_noise.h"
#include "vo/geometry/camera.h"

namespace synth {

/// A plane in closed form, to judge a depth sensor with: it meets the optical axis at `depth` (m)
/// and leans by `lean_deg` about the vertical, so that this is the incidence there.
DepthView plane_view(const vo::PinholeCamera& camera, double depth, double lean_deg);

}  // namespace synth
