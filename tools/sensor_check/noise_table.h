#pragma once

#include <string>
#include <vector>

#include "synth/sensor/sensor.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Error of measured depth on a plane.
struct DepthError {
  double mean = 0;       ///< m
  double deviation = 0;  ///< m
};

/// One place of a noise model: what its formula says and what was measured.
struct NoiseSample {
  synth::SensorPreset preset = synth::SensorPreset::perfect;
  double depth = 0;     ///< m
  double lean_deg = 0;  ///< deg, of the plane against the image's
  DepthError formula;
  DepthError measured;
};

/// A strip of a camera with the focal length of a Kinect, of which the middle columns are judged:
/// so few that a leaning plane has one incidence there.
vo::PinholeCamera strip_camera();

/// Closed form: the normal distributions of axial, lateral and normal noise through the roundings
/// of depth and disparity. Holes and flying pixels are left out.
DepthError expected_error(const synth::SensorOptions& sensor, double depth, double lean_deg);

/// From as many frames.
DepthError measured_error(const synth::SensorOptions& sensor, double depth, double lean_deg,
                          int frames);

/// Every preset but the perfect one over depths and leans.
std::vector<NoiseSample> measure_noise(int frames);

/// The image's noise of one even grey, in linear 0..1.
struct GreyNoise {
  synth::SensorPreset preset = synth::SensorPreset::perfect;
  double grey = 0;      ///< linear
  double formula = 0;   ///< standard deviation of green, linear
  double measured = 0;  ///< the same
};

std::vector<GreyNoise> measure_grey_noise();

std::string format_noise_csv(const std::vector<NoiseSample>& samples);
std::string format_grey_csv(const std::vector<GreyNoise>& samples);

/// Lines of the formulas, marks of what was measured: depth across and leaning, and the image.
std::string plot_noise(const std::vector<NoiseSample>& depth, const std::vector<GreyNoise>& grey);

}  // namespace tools
