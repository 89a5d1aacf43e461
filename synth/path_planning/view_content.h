#pragma once

#include "synth/ray_tracing/surface_tracer.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

/// Measures of how useful a view is to visual odometry.
struct ViewContent {
  double depth_share = 0;     ///< share of the pixels that see a surface
  double textured_share = 0;  ///< share of 4x4 px tiles with contrast and surfaces in reach
  double nearest = 0;         ///< m, least depth; 0 = nothing seen
};

/// Returns the content of a view. A tile is textured if all its pixels see surfaces, on average
/// nearer than `reach`, m, and its grey values (base colour, darkened by shadows) span more than
/// 0.08 of black to white. A camera of about 32x24 pixels is enough.
ViewContent view_content(const SurfaceTracer& tracer, const vo::CameraModel& camera,
                         const vo::SE3& T_world_camera, double reach);

/// Returns a camera with the field of view of `camera` that is `width` pixels wide.
vo::CameraModel thumbnail(const vo::CameraModel& camera, int width);

}  // namespace synth
