#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <Eigen/Core>

#include "synth/rendering/capture.h"
#include "synth/rendering/renderer.h"
#include "synth/sensor/depth_holes.h"
#include "synth/sensor/depth_noise.h"
#include "synth/sensor/exposure_control.h"
#include "synth/sensor/image_noise.h"
#include "synth/sensor/jpeg.h"
#include "synth/sensor/lens.h"
#include "synth/sensor/response.h"
#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace synth {

enum class SensorPreset { perfect, kinect_v1, azure_kinect, realsense_d435, icl_nuim, redwood };

constexpr auto enum_names(SensorPreset) {
  return std::array{std::pair{SensorPreset::perfect, "perfect"},
                    std::pair{SensorPreset::kinect_v1, "kinect-v1"},
                    std::pair{SensorPreset::azure_kinect, "azure-kinect"},
                    std::pair{SensorPreset::realsense_d435, "realsense-d435"},
                    std::pair{SensorPreset::icl_nuim, "icl-nuim"},
                    std::pair{SensorPreset::redwood, "redwood"}};
}

enum class DepthShutter {
  as_color,  ///< each row with the row of the same number
  global,    ///< all rows at once
};

constexpr auto enum_names(DepthShutter) {
  return std::array{std::pair{DepthShutter::as_color, "as_color"},
                    std::pair{DepthShutter::global, "global"}};
}

/// The depth camera and what it makes of depth, in this order: noise, flying pixels, holes,
/// rounding, registration to the colour image.
struct DepthSensorOptions {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< m, where it is in the colour camera
  double delay = 0;                                  ///< s, its stamp after the colour image's
  DepthShutter shutter = DepthShutter::as_color;
  NormalNoise normal;
  LateralNoise lateral;
  AxialNoise axial;
  DisparityNoise disparity;
  FlyingPixels flying;
  DepthHoles holes;
  double step = 0;  ///< m; 0 = continuous

  bool is_apart() const;  ///< whether it sees anything else than the colour camera
  void validate() const;  ///< throws vo::Error
};

/// From what a perfect sensor would see to what this one measures. The defaults are perfect.
struct SensorOptions {
  SensorPreset preset = SensorPreset::perfect;  ///< where the others start from
  std::uint64_t seed = 0;                       ///< of all effects, beside their own
  double exposure = 0;      ///< gain from linear radiance to linear 0..1; 0 = metered
  double min_depth = 0.01;  ///< m; nearer surfaces have no depth
  double max_depth = 1000;  ///< m; farther surfaces have no depth
  Shutter shutter;
  LensOptions lens;
  AutoExposureOptions auto_exposure;
  WhiteBalanceOptions white_balance;
  ImageNoiseOptions noise;
  ResponseOptions response;
  JpegOptions jpeg;
  DepthSensorOptions depth;

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, DepthSensorOptions& options) {
  visit("offset", options.offset, "of the depth camera, in the colour camera's axes, m");
  visit("delay", options.delay, "of depth's stamp after the colour image's, s");
  visit("shutter", options.shutter, "when the rows of depth are measured");
  visit("normal", options.normal, "");
  visit("lateral", options.lateral, "");
  visit("axial", options.axial, "");
  visit("disparity", options.disparity, "");
  visit("flying", options.flying, "");
  visit("holes", options.holes, "");
  visit("step", options.step, "depth is a multiple of it, m; 0 = continuous");
}

template <typename Visitor>
void visit_fields(Visitor& visit, SensorOptions& options) {
  visit("preset", options.preset, "option values that the others start from");
  visit("seed", options.seed, "of all effects, beside their own");
  visit("exposure", options.exposure, "gain from linear radiance to 0..1; 0 meters the scene once");
  visit("min_depth", options.min_depth, "nearer surfaces have no depth, m");
  visit("max_depth", options.max_depth, "farther surfaces have no depth, m");
  visit("shutter", options.shutter, "");
  visit("lens", options.lens, "");
  visit("auto_exposure", options.auto_exposure, "");
  visit("white_balance", options.white_balance, "");
  visit("noise", options.noise, "");
  visit("response", options.response, "");
  visit("jpeg", options.jpeg, "");
  visit("depth", options.depth, "");
}

/// The effects' seeds drawn from the one of all, which is then 0.
SensorOptions seeded(const SensorOptions& options);

/// How a camera set itself for a frame.
struct FrameSetting {
  std::uint64_t index = 0;                            ///< the noise's
  double exposure = 1;                                ///< gain from radiance to 0..1
  double amplification = 1;                           ///< how much of it is not by light
  double exposure_time = 0;                           ///< s
  Eigen::Vector3d balance = Eigen::Vector3d::Ones();  ///< gains of red, green, blue
};

/// Linear light to an image: lens, noise, saturation, balance, response, JPEG.
vo::ColorImage develop(const cv::Mat_<cv::Vec3f>& radiance, const vo::PinholeCamera& camera,
                       const SensorOptions& options, const FrameSetting& setting);

/// As the depth camera sees it, not registered.
vo::DepthImage measure_depth(const DepthView& view, const vo::PinholeCamera& camera,
                             const SensorOptions& options, std::uint64_t frame);

/// What a sensor measures that has an exposure and a range of depth, and no other effect.
/// `options.exposure` must be set (not metered).
vo::RgbdFrame measure(const RenderedFrame& ideal, double timestamp, const SensorOptions& options);

}  // namespace synth
