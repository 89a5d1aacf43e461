#pragma once

#include "synth/depth_sensor/depth_noise.h"
#include "vo/geometry/camera.h"

namespace synth {

/// Returns the exact view of a plane, for judging a depth sensor. The plane meets the optical axis
/// at `depth`, m, and is tilted by `lean_deg` about the vertical, its incidence there.
DepthView plane_view(const vo::PinholeCamera& camera, double depth, double lean_deg);

}  // namespace synth
