#include "synth/sensor/preset.h"

namespace synth {
namespace {

/// Focal length times baseline of the PrimeSense chip, px m: 585.5 px times 75 mm.
constexpr double kPrimeSenseFocalBaseline = 43.9125;

SensorOptions kinect_v1() {
  SensorOptions sensor{.min_depth = 0.5, .max_depth = 6};
  sensor.shutter = {.exposure_time = 0.015, .readout_time = 0.026};
  sensor.lens = {.blur = 0.7, .vignetting = {.cos_power = 4}};
  sensor.auto_exposure.enabled = true;
  sensor.white_balance.enabled = true;
  sensor.noise = {.full_well = {6000, 6000, 6000}, .read_noise = {15, 15, 15}, .pixel_gain = 0.01};
  DepthSensorOptions& depth = sensor.depth;
  depth.offset = {-0.025, 0, 0};
  depth.delay = 0.01;
  depth.materials = {.glass = ClearSurface::lost, .mirrors = ClearSurface::beyond};
  depth.lateral = {.sigma = 0.8, .grazing = 0.035};
  depth.axial = {.constant = 0.0012,
                 .quadratic = 0.0019,
                 .quadratic_from = 0.4,
                 .grazing = 0.0001,
                 .correlation = 1};
  depth.disparity = {.focal_baseline = kPrimeSenseFocalBaseline, .step = 0.125};
  depth.holes = {.max_incidence_deg = 82,
                 .sure_incidence_deg = 72,
                 .edge_loss = 0.25,
                 .second_view = 0.075,
                 .correlation = 1};
  depth.step = 0.001;
  return sensor;
}

SensorOptions azure_kinect() {
  SensorOptions sensor{.min_depth = 0.5, .max_depth = 3.86};
  sensor.shutter = {.exposure_time = 0.01, .readout_time = 0.02};
  sensor.lens = {.blur = 0.5, .vignetting = {.cos_power = 4}};
  sensor.auto_exposure.enabled = true;
  sensor.white_balance.enabled = true;
  sensor.noise = {.full_well = {9000, 9000, 9000}, .read_noise = {5, 5, 5}, .pixel_gain = 0.005};
  sensor.jpeg = {.quality = 90};
  DepthSensorOptions& depth = sensor.depth;
  depth.offset = {-0.032, 0, 0};
  depth.shutter = DepthShutter::global;
  depth.materials = {.glass = ClearSurface::beyond,
                     .mirrors = ClearSurface::beyond,
                     .solids = SolidGlass::refracted};
  depth.lateral = {.sigma = 0.25, .sampling = DepthSampling::linear};
  depth.axial = {.constant = 0.0005, .linear = 0.001, .linear_from = 0.5};
  depth.flying = {.share = 0.4};
  depth.holes = {.max_step = 0.8, .dark_level = 15};
  depth.step = 0.001;
  return sensor;
}

SensorOptions realsense_d435() {
  SensorOptions sensor{.min_depth = 0.28, .max_depth = 10};
  sensor.shutter = {.exposure_time = 0.012, .readout_time = 0.02};
  sensor.lens = {.blur = 0.6, .vignetting = {.cos_power = 4}};
  sensor.auto_exposure.enabled = true;
  sensor.white_balance.enabled = true;
  sensor.noise = {.full_well = {7000, 7000, 7000}, .read_noise = {8, 8, 8}, .pixel_gain = 0.01};
  DepthSensorOptions& depth = sensor.depth;
  depth.offset = {-0.015, 0, 0};
  depth.shutter = DepthShutter::global;
  depth.materials = {.glass = ClearSurface::beyond, .mirrors = ClearSurface::beyond};
  depth.disparity = {
      .focal_baseline = 21.2, .sigma = 0.08, .step = 0.03125, .correlation = 2};  // 424 px, 50 mm
  depth.flying = {.share = 0.2};
  depth.holes = {.max_incidence_deg = 84,
                 .sure_incidence_deg = 74,
                 .edge_loss = 0.3,
                 .second_view = 0.05,
                 .second_view_framed = true,
                 .correlation = 2};
  depth.step = 0.001;
  return sensor;
}

/// ICL-NUIM's noise: Handa, Whelan, McDonald & Davison, ICRA 2014, and their released code.
SensorOptions icl_nuim() {
  SensorOptions sensor;
  sensor.noise = {.full_well = {9246, 22957, 8900}, .read_noise = {41.6, 87.2, 44.5}};
  DepthSensorOptions& depth = sensor.depth;
  depth.normal = {.sigma = 0.8, .grazing = 0.035};
  depth.lateral = {.sigma = 0.70710678, .sampling = DepthSampling::linear};
  depth.disparity = {.focal_baseline = kPrimeSenseFocalBaseline,
                     .sigma = 1.0 / 48,
                     .step = 0.125,
                     .offset = 0.0625,
                     .depth_step = 0.01};
  depth.holes = {.max_incidence_deg = 82};
  return sensor;
}

/// Redwood's noise: Choi, Zhou & Koltun, CVPR 2015, without their sensor's distortion map.
SensorOptions redwood() {
  SensorOptions sensor{.max_depth = 10};
  sensor.depth.lateral = {.sigma = 0.25};
  sensor.depth.disparity = {.focal_baseline = 35.13, .sigma = 1.0 / 36, .step = 0.125};
  return sensor;
}

SensorOptions unnamed(SensorPreset preset) {
  switch (preset) {
    case SensorPreset::perfect:
      return {};
    case SensorPreset::kinect_v1:
      return kinect_v1();
    case SensorPreset::azure_kinect:
      return azure_kinect();
    case SensorPreset::realsense_d435:
      return realsense_d435();
    case SensorPreset::icl_nuim:
      return icl_nuim();
    case SensorPreset::redwood:
      return redwood();
  }
  return {};
}

}  // namespace

SensorOptions preset_options(SensorPreset preset) {
  SensorOptions sensor = unnamed(preset);
  sensor.preset = preset;
  return sensor;
}

}  // namespace synth
