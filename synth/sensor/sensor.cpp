#include "synth/sensor/sensor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vo/core/error.h"
#include "vo/core/hash.h"

namespace synth {
namespace {

/// Returns the image with each channel multiplied by its gain.
cv::Mat_<cv::Vec3f> scaled(const cv::Mat_<cv::Vec3f>& linear, const Eigen::Vector3d& gains) {
  const cv::Vec3f gain(static_cast<float>(gains[0]), static_cast<float>(gains[1]),
                       static_cast<float>(gains[2]));
  cv::Mat_<cv::Vec3f> result(linear.size());
  std::transform(linear.begin(), linear.end(), result.begin(),
                 [gain](const cv::Vec3f& rgb) { return rgb.mul(gain); });
  return result;
}

/// Returns the image limited to 1, at which a pixel's full well is reached.
cv::Mat_<cv::Vec3f> saturated(const cv::Mat_<cv::Vec3f>& linear) {
  return cv::Mat_<cv::Vec3f>(cv::min(linear, cv::Scalar::all(1)));
}

/// Returns an image whose channels are the green one of another.
vo::ColorImage green_in_all(const vo::ColorImage& image) {
  vo::ColorImage grey(image.size());
  std::transform(image.begin(), image.end(), grey.begin(),
                 [](const cv::Vec3b& bgr) { return cv::Vec3b::all(bgr[1]); });
  return grey;
}

vo::DepthImage in_range(const vo::DepthImage& depth, const SensorOptions& options) {
  vo::DepthImage result(depth.size());
  std::transform(depth.begin(), depth.end(), result.begin(), [&](float value) {
    return value >= options.min_depth && value <= options.max_depth ? value : 0.0F;
  });
  return result;
}

void round_to(double step, vo::DepthImage& depth) {
  for (float& value : depth) {
    value = static_cast<float>(step * std::round(value / step));
  }
}

bool is_share(double value) {
  return value >= 0 && value <= 1;
}

}  // namespace

vo::SE3 DepthSensorOptions::T_color_depth() const {
  vo::Vector6d rotation = vo::Vector6d::Zero();
  rotation.tail<3>() = turn * std::numbers::pi / 180;
  return {vo::SE3::exp(rotation).rotation(), offset};
}

bool DepthSensorOptions::is_elsewhere() const {
  return !offset.isZero(0) || !turn.isZero(0);
}

bool DepthSensorOptions::is_apart() const {
  return is_elsewhere() || delay != 0 || shutter == DepthShutter::global;
}

void DepthSensorOptions::validate() const {
  constexpr double kMaxOffset = 1000;     // m
  constexpr double kMaxDelay = 60;        // s
  constexpr double kMaxCorrelation = 50;  // px
  constexpr double kMaxTurn = 90;         // deg, beyond which the cameras see nothing in common
  vo::require(offset.allFinite() && offset.norm() <= kMaxOffset,
              "sensor.depth: expected an offset of at most ", kMaxOffset, " m, got ",
              offset.norm());
  vo::require(std::abs(delay) <= kMaxDelay, "sensor.depth: expected a delay from ", -kMaxDelay,
              " to ", kMaxDelay, " s, got ", delay);
  vo::require(turn.allFinite() && turn.norm() < kMaxTurn,
              "sensor.depth: expected a turn of less than ", kMaxTurn, " deg");
  for (const double sigma :
       {normal.sigma, normal.grazing, lateral.sigma, lateral.grazing, axial.constant, axial.linear,
        axial.quadratic, axial.grazing, disparity.focal_baseline, disparity.sigma, disparity.step,
        disparity.depth_step, holes.max_step, holes.dark_level, materials.min_return, step}) {
    vo::require(sigma >= 0 && std::isfinite(sigma),
                "sensor.depth: expected standard deviations, steps and levels at or above 0, got ",
                sigma);
  }
  for (const double correlation : {axial.correlation, disparity.correlation, holes.correlation}) {
    vo::require(correlation >= 0 && correlation <= kMaxCorrelation,
                "sensor.depth: expected a correlation from 0 to ", kMaxCorrelation, " px, got ",
                correlation);
  }
  multipath.validate();
  vo::require(is_share(flying.share) && is_share(holes.edge_loss),
              "sensor.depth: expected flying.share and holes.edge_loss from 0 to 1, got ",
              flying.share, ", ", holes.edge_loss);
  vo::require(holes.max_incidence_deg > 0 && holes.sure_incidence_deg > 0,
              "sensor.depth.holes: expected incidences above 0 deg");
}

void SensorOptions::validate() const {
  vo::require(exposure >= 0 && std::isfinite(exposure),
              "sensor: expected exposure at or above 0, got ", exposure);
  vo::require(min_depth >= 0 && max_depth > min_depth,
              "sensor: expected 0 <= min_depth < max_depth, got ", min_depth, ", ", max_depth);
  vo::require(exposure == 0 || !auto_exposure.enabled,
              "sensor: auto_exposure expects exposure = 0 (metered), got ", exposure);
  shutter.validate();
  flicker.validate();
  lens.validate();
  auto_exposure.validate();
  white_balance.validate();
  noise.validate();
  response.validate();
  jpeg.validate();
  depth.validate();
}

SensorOptions seeded(const SensorOptions& options) {
  SensorOptions result = options;
  for (std::uint64_t* seed :
       {&result.noise.seed, &result.depth.multipath.seed, &result.depth.normal.seed,
        &result.depth.lateral.seed, &result.depth.axial.seed, &result.depth.disparity.seed,
        &result.depth.flying.seed, &result.depth.holes.seed}) {
    *seed = vo::mixed(options.seed) ^ *seed;
  }
  result.seed = 0;
  return result;
}

vo::ColorImage develop(const cv::Mat_<cv::Vec3f>& radiance, const vo::CameraModel& camera,
                       const SensorOptions& options, const FrameSetting& setting) {
  cv::Mat_<cv::Vec3f> linear = scaled(through_lens(radiance, camera, options.lens),
                                      Eigen::Vector3d::Constant(setting.exposure));
  if (options.flicker.is_on()) {
    linear = with_flicker(linear, options.flicker,
                          {setting.exposure_time, options.shutter.readout_time}, setting.stamp);
  }
  if (options.noise.is_on()) {
    linear = with_image_noise(linear, options.noise, setting.amplification, setting.index);
  }
  if (!setting.balance.isOnes(0) && !setting.is_infrared) {
    linear = scaled(saturated(linear), setting.balance);
  }
  const vo::ColorImage colors = encode(linear, options.response);
  const vo::ColorImage image = setting.is_infrared ? green_in_all(colors) : colors;
  return options.jpeg.quality > 0 ? through_jpeg(image, options.jpeg) : image;
}

vo::DepthImage measure_depth(const DepthView& view, const vo::CameraModel& camera,
                             const SensorOptions& options, std::uint64_t frame) {
  const DepthSensorOptions& sensor = options.depth;
  const auto seen = [&](const vo::DepthImage& depth) { return DepthView{depth, view.normal}; };
  vo::DepthImage depth = with_normal_noise(view, camera, sensor.normal, frame);
  depth = with_lateral_noise(seen(depth), camera, sensor.lateral, frame);
  depth = with_axial_noise(seen(depth), camera, sensor.axial, frame);
  depth = with_disparity_noise(depth, sensor.disparity, frame);
  depth = with_flying_pixels(depth, view.depth, sensor.flying, frame);
  depth = in_range(with_holes(depth, view, camera, sensor.holes, frame), options);
  if (sensor.step > 0) {
    round_to(sensor.step, depth);
  }
  return depth;
}

vo::RgbdFrame measure(const RenderedFrame& ideal, double timestamp, const SensorOptions& options) {
  vo::require(options.exposure > 0, "sensor: expected an exposure above 0, got ", options.exposure);
  return {.timestamp = timestamp,
          .image = encode(scaled(ideal.radiance, Eigen::Vector3d::Constant(options.exposure)), {}),
          .depth = in_range(ideal.depth, options)};
}

}  // namespace synth
