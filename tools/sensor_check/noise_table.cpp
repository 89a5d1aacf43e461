#include "tools/sensor_check/noise_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "synth/depth_sensor/plane_view.h"
#include "synth/sensor/preset.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using synth::DepthSensorOptions;

constexpr int kJudgedColumns = 5;
constexpr double kTails = 6;  // half width of the sums, standard deviations

/// Mean and mean square of a random depth error in m and m^2.
struct ErrorMoments {
  double mean = 0;
  double square = 0;

  void add(double error, double probability) {
    mean += probability * error;
    square += probability * error * error;
  }
};

double normal_share(double value) {
  return std::erfc(-value / std::numbers::sqrt2) / 2;
}

/// Visits every value and probability of step round(n / step) for a normal variable n.
template <typename Visit>
void visit_rounded(double mean, double sigma, double step, const Visit& visit) {
  const double spread = std::max(sigma, 1e-9 * step);
  const auto first = static_cast<long>(std::floor((mean - kTails * spread) / step));
  const auto last = static_cast<long>(std::ceil((mean + kTails * spread) / step));
  for (long i = first; i <= last; ++i) {
    const double value = static_cast<double>(i) * step;
    const double share = normal_share((value + step / 2 - mean) / spread) -
                         normal_share((value - step / 2 - mean) / spread);
    visit(value, share);
  }
}

/// Returns the standard deviation of the sampled position, px.
double lateral_deviation(const synth::LateralNoise& noise, double incidence) {
  const double sigma = synth::lateral_sigma(noise.sigma, noise.grazing, incidence);
  if (noise.sampling == synth::DepthSampling::linear || sigma == 0) {
    return sigma;
  }
  double variance = 0;
  visit_rounded(0, sigma, 1, [&](double px, double share) { variance += share * px * px; });
  return std::sqrt(variance);
}

/// Returns the factor on the standard deviation of white noise by linear interpolation at random
/// places, which keeps 2 / 3 of the variance, the mean of (1 - a)^2 + a^2, in each of u and v.
double kept_by_sampling(const synth::LateralNoise& noise) {
  return noise.sigma > 0 && noise.sampling == synth::DepthSampling::linear ? 2.0 / 3 : 1;
}

/// Adds the error by disparity noise. Quantised disparity gives discrete depths, each of which the
/// rounding of depth shifts.
void add_disparity_error(const DepthSensorOptions& sensor, double depth, double sigma_px,
                         double truth, double probability, ErrorMoments& moments) {
  const synth::DisparityNoise& noise = sensor.disparity;
  const double disparity = noise.focal_baseline / depth + noise.offset;
  if (noise.step == 0) {
    const double sigma_m = sigma_px * depth * depth / noise.focal_baseline;
    moments.add(noise.focal_baseline / disparity - truth, probability);
    moments.square += probability * (sigma_m * sigma_m + sensor.step * sensor.step / 12);
    return;
  }
  visit_rounded(disparity, sigma_px, noise.step, [&](double rounded, double share) {
    if (rounded > 0) {
      const double value = noise.focal_baseline / rounded;
      const double shown = sensor.step > 0 ? sensor.step * std::round(value / sensor.step) : value;
      moments.add(shown - truth, probability * share);
    }
  });
}

/// Returns the depth error after disparity quantisation of depths with normal noise `sigma`, m.
ErrorMoments through_disparity(const DepthSensorOptions& sensor, double depth, double sigma) {
  const synth::DisparityNoise& noise = sensor.disparity;
  ErrorMoments moments;
  if (noise.focal_baseline == 0) {
    moments.square = sigma * sigma + sensor.step * sensor.step / 12;
  } else if (noise.depth_step > 0) {
    visit_rounded(depth, sigma, noise.depth_step, [&](double rounded, double share) {
      add_disparity_error(sensor, rounded, noise.sigma, depth, share, moments);
    });
  } else {
    const double before_px = sigma * noise.focal_baseline / (depth * depth);
    add_disparity_error(sensor, depth, std::hypot(noise.sigma, before_px), depth, 1, moments);
  }
  return moments;
}

/// Returns the expected depth error at one pixel of a plane.
ErrorMoments expected_at(const DepthSensorOptions& sensor, const synth::DepthView& view,
                         const vo::PinholeCamera& camera, const cv::Point& pixel) {
  const double depth = view.depth(pixel);
  const double incidence = synth::incidence(view, camera, pixel);
  const double slope =
      (view.depth(pixel.y, pixel.x + 1) - view.depth(pixel.y, pixel.x - 1)) / 2.0;  // m per px
  const double lateral = lateral_deviation(sensor.lateral, incidence) * slope;
  const double along_normal =
      synth::lateral_sigma(sensor.normal.sigma, sensor.normal.grazing, incidence) * depth /
      camera.fx * view.normal(pixel)[2] * kept_by_sampling(sensor.lateral);
  const double axial = synth::axial_sigma(sensor.axial, depth, incidence);
  return through_disparity(sensor, depth, std::hypot(axial, lateral, along_normal));
}

/// Returns the sensor without holes, flying pixels and depth limits.
synth::SensorOptions without_holes(const synth::SensorOptions& sensor) {
  synth::SensorOptions noise = sensor;
  noise.min_depth = 0.01;
  noise.max_depth = 1000;
  noise.depth.holes = {};
  noise.depth.flying = {};
  return noise;
}

DepthError error_of(const ErrorMoments& sum, double count) {
  const double mean = sum.mean / count;
  return {mean, std::sqrt(std::max(0.0, sum.square / count - mean * mean))};
}

int first_judged(const vo::PinholeCamera& camera) {
  return (camera.width - kJudgedColumns) / 2;
}

/// Returns the depth error measured over simulated frames, each of which is told.
DepthError measured_error(const synth::SensorOptions& sensor, double depth, double lean_deg,
                          int frames, const std::function<void()>& frame_done) {
  const vo::PinholeCamera camera = strip_camera();
  const synth::DepthView view = synth::plane_view(camera, depth, lean_deg);
  const synth::SensorOptions noise = without_holes(sensor);
  ErrorMoments sum;
  for (int frame = 0; frame < frames; ++frame) {
    const vo::DepthImage measured =
        synth::measure_depth(view, camera, noise, static_cast<std::uint64_t>(frame));
    for (int v = 0; v < camera.height; ++v) {
      for (int i = 0; i < kJudgedColumns; ++i) {
        const int u = first_judged(camera) + i;
        sum.add(static_cast<double>(measured(v, u)) - view.depth(v, u), 1);
      }
    }
    frame_done();
  }
  return error_of(sum, static_cast<double>(frames) * camera.height * kJudgedColumns);
}

/// Returns every preset except the perfect one.
std::vector<synth::SensorPreset> noisy_presets() {
  std::vector<synth::SensorPreset> presets;
  for (const auto& [preset, name] : enum_names(synth::SensorPreset{})) {
    if (preset != synth::SensorPreset::perfect) {
      presets.push_back(preset);
    }
  }
  return presets;
}

}  // namespace

vo::PinholeCamera strip_camera() {
  return {.width = 41, .height = 480, .fx = 525, .fy = 525, .cx = 20, .cy = 239.5};
}

DepthError expected_error(const synth::SensorOptions& sensor, double depth, double lean_deg) {
  const vo::PinholeCamera camera = strip_camera();
  const synth::DepthView view = synth::plane_view(camera, depth, lean_deg);
  ErrorMoments sum;
  for (int i = 0; i < kJudgedColumns; ++i) {
    const ErrorMoments moments =
        expected_at(sensor.depth, view, camera, {first_judged(camera) + i, camera.height / 2});
    sum.mean += moments.mean;
    sum.square += moments.square;
  }
  return error_of(sum, kJudgedColumns);
}

std::vector<NoiseSample> measure_noise(int frames, const vo::Progress& progress) {
  constexpr std::array kLeansDeg{0.0, 40.0, 70.0};
  constexpr std::array kDepths{0.6, 0.8, 1.1, 1.5, 2.0, 2.7, 3.6};
  const std::vector<synth::SensorPreset> presets = noisy_presets();
  const std::size_t total =
      presets.size() * kLeansDeg.size() * kDepths.size() * static_cast<std::size_t>(frames);
  std::size_t done = 0;
  const auto frame_done = [&] { progress(++done, total); };
  std::vector<NoiseSample> samples;
  for (const synth::SensorPreset preset : presets) {
    const synth::SensorOptions sensor = synth::preset_options(preset);
    for (const double lean_deg : kLeansDeg) {
      for (const double depth : kDepths) {
        samples.push_back({preset, depth, lean_deg, expected_error(sensor, depth, lean_deg),
                           measured_error(sensor, depth, lean_deg, frames, frame_done)});
      }
    }
  }
  return samples;
}

std::vector<GreyNoise> measure_grey_noise() {
  std::vector<GreyNoise> samples;
  for (const auto& [preset, name] : enum_names(synth::SensorPreset{})) {
    const synth::ImageNoiseOptions noise = synth::preset_options(preset).noise;
    for (const double grey : {0.003, 0.01, 0.03, 0.1, 0.3, 0.9}) {
      if (!noise.is_on()) {
        continue;
      }
      const auto value = static_cast<float>(grey);
      const cv::Mat_<cv::Vec3f> even(240, 320, cv::Vec3f(value, value, value));
      cv::Scalar mean;
      cv::Scalar deviation;
      cv::meanStdDev(synth::with_image_noise(even, noise, 1, 0), mean, deviation);
      const double variance = grey / noise.full_well[1] +
                              std::pow(noise.read_noise[1] / noise.full_well[1], 2) +
                              std::pow(grey * noise.pixel_gain, 2);
      samples.push_back({preset, grey, std::sqrt(variance), deviation[1]});
    }
  }
  return samples;
}

double worst_share(const std::vector<NoiseSample>& samples) {
  double worst = 0;
  for (const NoiseSample& sample : samples) {
    worst = std::max(worst, std::abs(sample.measured.deviation / sample.formula.deviation - 1));
  }
  return worst;
}

double worst_share(const std::vector<GreyNoise>& samples) {
  double worst = 0;
  for (const GreyNoise& sample : samples) {
    worst = std::max(worst, std::abs(sample.measured / sample.formula - 1));
  }
  return worst;
}

std::string format_noise_csv(const std::vector<NoiseSample>& samples) {
  std::string text =
      "preset,depth_m,incidence_deg,formula_deviation_m,measured_deviation_m,formula_bias_m,"
      "measured_bias_m\n";
  for (const NoiseSample& sample : samples) {
    text += vo::concat(vo::to_string(sample.preset), ",", vo::format_real(sample.depth), ",",
                       vo::format_real(sample.lean_deg), ",", sample.formula.deviation, ",",
                       sample.measured.deviation, ",", sample.formula.mean, ",",
                       sample.measured.mean, "\n");
  }
  return text;
}

std::string format_grey_csv(const std::vector<GreyNoise>& samples) {
  std::string text = "preset,grey,formula_deviation,measured_deviation\n";
  for (const GreyNoise& sample : samples) {
    text += vo::concat(vo::to_string(sample.preset), ",", vo::format_real(sample.grey), ",",
                       sample.formula, ",", sample.measured, "\n");
  }
  return text;
}

}  // namespace tools
