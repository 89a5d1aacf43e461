#pragma once

#include <Eigen/Core>

#include "synth/camera/renderers_over_time.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// What a camera's metering makes of a view, rendered small.
struct Metering {
  double exposure = 1;  ///< brings the median to 18 % grey; 1 in the dark
  Eigen::Vector3d mean = Eigen::Vector3d::Ones();  ///< linear RGB; 1 in the dark
};

Metering meter(const Renderer& renderer, const vo::PinholeCamera& camera,
               const vo::SE3& T_world_camera);

/// The gain that brings the middle of what the camera sees to 18 % grey, rendered small at eight
/// poses spread over the trajectory, the scene as it is then; 1 for a scene without lights, whose
/// colours are final.
double meter_exposure(const Scene& scene, const RenderersOverTime& renderers,
                      const vo::PinholeCamera& camera, const vo::Trajectory& trajectory);

}  // namespace synth
