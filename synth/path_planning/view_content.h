#pragma once

#include "synth/ray_tracing/surface_tracer.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace synth {

/// What a view offers to visual odometry.
struct ViewContent {
  double depth_share = 0;     ///< of the pixels: there is a surface
  double textured_share = 0;  ///< of the tiles of 4x4 pixels: a surface in reach, and contrast
  double nearest = 0;         ///< m, least depth; 0 = nothing seen
};

/// The tiles count whose surfaces are on average nearer than `reach`, m, and whose grey values span
/// more than 0.08 of black to white: base colours, darkened by the light's share that shadows take.
/// A camera of about 32x24 pixels is enough.
ViewContent view_content(const SurfaceTracer& tracer, const vo::PinholeCamera& camera,
                         const vo::SE3& T_world_camera, double reach);

/// The same view in fewer pixels: as wide, of square pixels, and `width` of them.
vo::PinholeCamera thumbnail(const vo::PinholeCamera& camera, int width);

}  // namespace synth
