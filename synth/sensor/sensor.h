#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <Eigen/Core>

#include "synth/depth_sensor/depth_holes.h"
#include "synth/depth_sensor/depth_materials.h"
#include "synth/depth_sensor/depth_noise.h"
#include "synth/rendering/capture.h"
#include "synth/rendering/multipath.h"
#include "synth/rendering/renderer.h"
#include "synth/sensor/exposure_control.h"
#include "synth/sensor/flicker.h"
#include "synth/sensor/image_noise.h"
#include "synth/sensor/jpeg.h"
#include "synth/sensor/lens.h"
#include "synth/sensor/response.h"
#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

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
  as_color,  ///< each row is measured with the colour row of equal number
  global,    ///< all rows are measured at once
};

constexpr auto enum_names(DepthShutter) {
  return std::array{std::pair{DepthShutter::as_color, "as_color"},
                    std::pair{DepthShutter::global, "global"}};
}

/// The depth camera and its effects on depth, in this order: materials, multipath, noise, flying
/// pixels, holes, rounding, registration to the colour image.
struct DepthSensorOptions {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< m, position in the colour camera's axes
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();    ///< deg, rotation vector in those axes
  double delay = 0;  ///< s, from the colour image's stamp to depth's
  DepthShutter shutter = DepthShutter::as_color;
  DepthMaterials materials;
  MultipathOptions multipath;
  NormalNoise normal;
  LateralNoise lateral;
  AxialNoise axial;
  DisparityNoise disparity;
  FlyingPixels flying;
  DepthHoles holes;
  double step = 0;  ///< m, quantisation of depth; 0 = continuous

  vo::SE3 T_color_depth() const;  ///< of offset and turn
  bool is_elsewhere() const;      ///< whether depth is registered to the colour image
  bool is_apart() const;          ///< whether depth needs a capture of its own
  void validate() const;          ///< throws vo::Error if out of range
};

/// All effects between ideal images and what a sensor measures. The defaults are a perfect sensor.
struct SensorOptions {
  SensorPreset preset = SensorPreset::perfect;  ///< preset that the other options start from
  std::uint64_t seed = 0;                       ///< common seed, mixed into each effect's own
  double exposure = 0;      ///< gain from linear radiance to linear 0..1; 0 = metered
  double min_depth = 0.01;  ///< m; nearer surfaces have no depth
  double max_depth = 1000;  ///< m; farther surfaces have no depth
  Shutter shutter;
  FlickerOptions flicker;
  LensOptions lens;
  AutoExposureOptions auto_exposure;
  WhiteBalanceOptions white_balance;
  ImageNoiseOptions noise;
  ResponseOptions response;
  JpegOptions jpeg;
  DepthSensorOptions depth;

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, DepthSensorOptions& options) {
  visit("offset", options.offset, "of the depth camera, in the colour camera's axes, m");
  visit("turn", options.turn, "of the depth camera, rotation vector in those axes, deg");
  visit("delay", options.delay, "of depth's stamp after the colour image's, s");
  visit("shutter", options.shutter, "when the rows of depth are measured");
  visit("materials", options.materials, "");
  visit("multipath", options.multipath, "");
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
  visit("flicker", options.flicker, "");
  visit("lens", options.lens, "");
  visit("auto_exposure", options.auto_exposure, "");
  visit("white_balance", options.white_balance, "");
  visit("noise", options.noise, "");
  visit("response", options.response, "");
  visit("jpeg", options.jpeg, "");
  visit("depth", options.depth, "");
}

/// Returns options with the common seed mixed into each effect's seed; the common seed is then 0.
SensorOptions seeded(const SensorOptions& options);

/// The exposure and white balance of one frame.
struct FrameSetting {
  std::uint64_t index = 0;   ///< frame index, for the noise
  double stamp = 0;          ///< s, for the flicker
  double exposure = 1;       ///< gain from radiance to 0..1
  double amplification = 1;  ///< factor of `exposure` due to signal gain, not light
  double exposure_time = 0;  ///< s in which each row collects light
  Eigen::Vector3d balance = Eigen::Vector3d::Ones();  ///< gains of red, green, blue
  bool is_infrared = false;  ///< the radiance is grey, and the sensor has no colour filters
};

/// Returns the image of linear radiance after lens, flicker, noise, saturation, white balance,
/// response and JPEG. An infrared camera's image is grey: what the sensor makes of green, which no
/// white balance changes, stands in all channels.
vo::ColorImage develop(const cv::Mat_<cv::Vec3f>& radiance, const vo::CameraModel& camera,
                       const SensorOptions& options, const FrameSetting& setting);

/// Returns the depth that the depth camera measures, not registered to the colour image.
vo::DepthImage measure_depth(const DepthView& view, const vo::CameraModel& camera,
                             const SensorOptions& options, std::uint64_t frame);

/// Returns what a sensor measures whose only effects are an exposure and a depth range. Throws
/// vo::Error unless `options.exposure` is above 0.
vo::RgbdFrame measure(const RenderedFrame& ideal, double timestamp, const SensorOptions& options);

}  // namespace synth
