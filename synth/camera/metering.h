#pragma once

#include <Eigen/Core>

#include "synth/camera/renderers_over_time.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// The exposure and mean colour that a camera meters from a small rendering of a view.
struct Metering {
  double exposure = 1;  ///< gain that brings the median luminance to 18 % grey; 1 in the dark
  Eigen::Vector3d mean = Eigen::Vector3d::Ones();  ///< mean linear RGB of the view; 1 in the dark
};

Metering meter(const Renderer& renderer, const vo::PinholeCamera& camera,
               const vo::SE3& T_world_camera);

/// Returns the gain that brings the median luminance to 18 % grey over eight poses spread over the
/// trajectory, rendered small with the scene at those times, of which the first is `scene_delay`,
/// s, of its animations; 1 for a scene without lights or lit surfaces, whose colours are final, and
/// for an empty trajectory.
double meter_exposure(const Scene& scene, const RenderersOverTime& renderers,
                      const vo::PinholeCamera& camera, const vo::Trajectory& trajectory,
                      double scene_delay = 0);

}  // namespace synth
