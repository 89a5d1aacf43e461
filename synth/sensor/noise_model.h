#pragma once

#include "synth/sensor/sensor.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/depth_noise.h"

namespace synth {

/// Returns the variance, m^2, of the depth that a sensor measures of a wall seen head-on and that
/// is written in the camera's depth units: all noise and rounding along the optical axis, but
/// neither lateral noise nor lost and flying pixels.
double depth_variance(const SensorOptions& sensor, const vo::RgbdCameraModel& camera, double depth);

/// Returns the model of depth noise nearest to a sensor's depth_variance() between 0.5 and 5 m, by
/// least squares of the relative errors of the variance. It is exact but for axial noise that grows
/// from another depth than 0.
vo::DepthNoise depth_noise_model(const SensorOptions& sensor, const vo::RgbdCameraModel& camera);

}  // namespace synth
