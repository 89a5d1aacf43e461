#pragma once

#include <optional>

#include <Eigen/Core>

#include "synth/camera/renderers_over_time.h"
#include "synth/rendering/infrared.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// The exposure and mean colour that a camera meters from a small rendering of a view.
struct Metering {
  double exposure = 1;  ///< gain that brings the median luminance to 18 % grey; 1 in the dark
  Eigen::Vector3d mean = Eigen::Vector3d::Ones();  ///< mean linear RGB of the view; 1 in the dark
};

/// Meters what a camera sees. The exposure of an infrared one brings the mean instead of the median
/// to 18 % grey, since most of a dark view may lie between the dots of a pattern.
Metering meter(const Renderer& renderer, const vo::CameraModel& camera,
               const vo::SE3& T_world_camera,
               const std::optional<InfraredBand>& infrared = std::nullopt);

/// Returns the gain that brings the median luminance, or an infrared camera's mean, to 18 % grey
/// over eight poses spread over the trajectory, rendered small with the scene at those times, of
/// which the first is `scene_delay`, s, of its animations; 1 for an empty trajectory and, but for
/// infrared cameras, for a scene without lights or lit surfaces, whose colours are final.
double meter_exposure(const Scene& scene, const RenderersOverTime& renderers,
                      const vo::CameraModel& camera, const vo::Trajectory& trajectory,
                      double scene_delay = 0,
                      const std::optional<InfraredBand>& infrared = std::nullopt);

}  // namespace synth
