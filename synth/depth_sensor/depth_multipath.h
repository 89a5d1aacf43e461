#pragma once

#include "synth/rendering/multipath.h"
#include "synth/rendering/renderer.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// Returns the frame with the depths that a time-of-flight camera measures where light reaches it
/// by way of other surfaces, as MultipathOptions say: of opaque surfaces, also of those that are
/// seen through glass and by mirrors. Glass and mirrors themselves keep their depths, and so do all
/// surfaces of a frame without DepthSight::multipath.
///
/// Light from elsewhere over light that returns straight, a complex number, does not depend on a
/// diffuse surface's colour. It is fitted as a linear function of place over the pixels of a window
/// that lie in the surface's plane, each of which counts for as much as it returns, so that few
/// paths for each pixel do. Where the depth is lost or would be negative, there is no surface.
RenderedFrame with_multipath(const RenderedFrame& frame, const vo::CameraModel& camera,
                             const MultipathOptions& options);

}  // namespace synth
