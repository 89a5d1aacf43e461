#pragma once

#include "synth/sensor/sensor.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// Throws vo::Error, which names the option, where an effect is on that is made for the images of
/// pinhole cameras and the camera is another: of the lens, of triangulation, of another place, and
/// whatever compares or blurs neighbouring pixels of depth, which elsewhere are not equally far
/// apart and go on across the border.
void require_pinhole_effects(const SensorOptions& options, const vo::CameraModel& camera);

}  // namespace synth
