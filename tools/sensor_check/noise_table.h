#pragma once

#include <string>
#include <vector>

#include "synth/sensor/sensor.h"
#include "vo/core/progress.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Error of measured depth on a plane: mean (bias) and standard deviation.
struct DepthError {
  double mean = 0;       ///< m
  double deviation = 0;  ///< m
};

/// One operating point of a depth noise model: error by formula and as measured.
struct NoiseSample {
  synth::SensorPreset preset = synth::SensorPreset::perfect;
  double depth = 0;     ///< m
  double lean_deg = 0;  ///< angle between the plane and the image plane, deg
  DepthError formula;
  DepthError measured;
};

/// Returns a narrow strip of a camera with the Kinect's focal length. Only its few middle columns
/// are evaluated, so that the incidence on a leaning plane is nearly constant.
vo::PinholeCamera strip_camera();

/// Returns the depth error in closed form: normal distributions of axial, lateral and normal noise
/// through the rounding of depth and disparity. Holes and flying pixels are left out.
DepthError expected_error(const synth::SensorOptions& sensor, double depth, double lean_deg);

/// Evaluates every preset except the perfect one over depths and angles, each measured over
/// `frames` simulated frames, which are the steps of the progress.
std::vector<NoiseSample> measure_noise(int frames, const vo::Progress& progress);

/// Image noise on a uniform grey, in linear intensity 0..1.
struct GreyNoise {
  synth::SensorPreset preset = synth::SensorPreset::perfect;
  double grey = 0;      ///< linear intensity
  double formula = 0;   ///< predicted standard deviation of the green channel
  double measured = 0;  ///< measured standard deviation of the green channel
};

std::vector<GreyNoise> measure_grey_noise();

/// Returns the greatest relative difference of a measured deviation from its formula.
double worst_share(const std::vector<NoiseSample>& samples);
double worst_share(const std::vector<GreyNoise>& samples);

std::string format_noise_csv(const std::vector<NoiseSample>& samples);
std::string format_grey_csv(const std::vector<GreyNoise>& samples);

/// Returns an SVG with lines for the formulas and marks for the measurements: panels of depth noise
/// at 0 and 70 deg and of image noise.
std::string plot_noise(const std::vector<NoiseSample>& depth, const std::vector<GreyNoise>& grey);

}  // namespace tools
