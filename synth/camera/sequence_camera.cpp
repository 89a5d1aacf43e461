#include "synth/camera/sequence_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

#include "synth/depth_sensor/depth_materials.h"
#include "synth/depth_sensor/depth_multipath.h"
#include "synth/depth_sensor/depth_registration.h"
#include "synth/ray_tracing/depth_sight_tracer.h"
#include "synth/scene/scene_motion.h"
#include "vo/core/hash.h"

namespace synth {
namespace {

/// Returns the time span in which the capture's rows are exposed, s of the scene's animations.
TimeSpan span_of(const Capture& capture) {
  const int height = capture.camera.height();
  return {capture.scene_time + capture.shutter.time_in_row(0, 0, height),
          capture.scene_time + capture.shutter.time_in_row(height - 1, 1, height)};
}

/// Returns the camera to whose image depth is registered from another place.
const vo::PinholeCamera& registered_to(const vo::CameraModel& camera) {
  return camera.pinhole_for("sensor.depth.offset, sensor.depth.turn");
}

}  // namespace

CameraPath path_through(const vo::Trajectory& poses) {
  if (poses.size() < 2) {
    vo::SE3 only = poses.empty() ? vo::SE3() : poses[0].T_world_camera;
    return [only](double) { return only; };
  }
  return spline(poses);
}

bool sees_materials(const Scene& scene, const SensorOptions& options) {
  const DepthMaterials& materials = options.depth.materials;
  return materials.min_return > 0 || (materials.is_on() && may_show_clear_surfaces(scene));
}

SequenceCamera::SequenceCamera(const Scene& scene, const RenderersOverTime& renderers,
                               const vo::CameraModel& camera, const CameraTruth& motion,
                               const SensorOptions& options, std::optional<InfraredBand> infrared)
    : renderers_(renderers),
      camera_(camera),
      motion_(motion),
      options_(seeded(options)),
      infrared_(std::move(infrared)),
      sees_materials_(sees_materials(scene, options)),
      settings_(motion.truth.size()) {
  const double exposure =
      options.exposure > 0
          ? options.exposure
          : meter_exposure(scene, renderers, camera, motion.truth, motion.scene_delay, infrared_);
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    settings_[i] = {.index = i,
                    .stamp = motion.truth[i].timestamp,
                    .exposure = exposure,
                    .exposure_time = options.shutter.exposure_time,
                    .balance = {options.white_balance.red, 1, options.white_balance.blue},
                    .is_infrared = infrared_.has_value()};
  }
  if (options.auto_exposure.enabled || options.white_balance.enabled) {
    const std::vector<Metering> metered = meter_frames();
    follow_exposure(metered);
    follow_balance(metered);
  }
}

std::vector<Metering> SequenceCamera::meter_frames() const {
  std::vector<Metering> metered(motion_.truth.size());
  tbb::parallel_for(std::size_t{0}, metered.size(), [&](std::size_t i) {
    metered[i] = meter(*renderer_at(i), camera_, motion_.truth[i].T_world_camera, infrared_);
  });
  return metered;
}

std::shared_ptr<const Renderer> SequenceCamera::renderer_at(std::size_t index) const {
  return renderers_.at(scene_time_of(index));
}

/// Returns the time of a frame's stamp, s of the scene's animations.
double SequenceCamera::scene_time_of(std::size_t index) const {
  return scene_time(motion_.truth, motion_.truth[index].timestamp) + motion_.scene_delay;
}

std::vector<double> SequenceCamera::stamps() const {
  std::vector<double> times;
  for (const vo::StampedPose& pose : motion_.truth) {
    times.push_back(pose.timestamp);
  }
  return times;
}

/// Follows the exposure metered for each frame. The exposure metered for the whole sequence is
/// reached with the shutter's own exposure time and no amplification.
void SequenceCamera::follow_exposure(const std::vector<Metering>& metered) {
  const AutoExposureOptions& control = options_.auto_exposure;
  if (!control.enabled) {
    return;
  }
  std::vector<double> wanted;
  for (const Metering& frame : metered) {
    wanted.push_back(std::log(frame.exposure));
  }
  const std::vector<double> followed_log =
      followed(stamps(), wanted, control.time_constant, control.delay);
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    FrameSetting& setting = settings_[i];
    const double change = std::exp(followed_log[i]) / setting.exposure;
    setting.exposure *= change;
    setting.amplification = change;
    if (control.by == ExposureBy::time && setting.exposure_time > 0) {
      const double longest = std::max(control.max_exposure_time, setting.exposure_time);
      const double stretch = std::min(change, longest / setting.exposure_time);
      setting.exposure_time *= stretch;
      setting.amplification = change / stretch;
    }
  }
}

void SequenceCamera::follow_balance(const std::vector<Metering>& metered) {
  const WhiteBalanceOptions& control = options_.white_balance;
  if (!control.enabled) {
    return;
  }
  for (const int channel : {0, 2}) {
    std::vector<double> wanted;
    for (const Metering& frame : metered) {
      wanted.push_back(std::log(frame.mean[1] / frame.mean[channel]));
    }
    const std::vector<double> followed_log =
        followed(stamps(), wanted, control.time_constant, control.delay);
    for (std::size_t i = 0; i < settings_.size(); ++i) {
      settings_[i].balance[channel] *= std::exp(followed_log[i]);
    }
  }
  for (FrameSetting& setting : settings_) {
    setting.balance /= setting.balance.minCoeff();  // least gain 1: saturated pixels stay white
  }
}

Capture SequenceCamera::color_capture(std::size_t index) const {
  const auto& [stamp, T_world_camera] = motion_.truth[index];
  Capture capture = still(camera_, T_world_camera);
  capture.shutter = options_.shutter;
  capture.shutter.exposure_time = settings_[index].exposure_time;
  capture.seed = vo::mixed(options_.noise.seed) + index;
  capture.solids = options_.depth.materials.solids;
  capture.multipath = options_.depth.multipath;
  capture.multipath.seed = vo::mixed(capture.multipath.seed) + index;
  capture.scene_time = scene_time_of(index);
  capture.infrared = infrared_;
  if (capture.shutter.exposure_time > 0 || capture.shutter.readout_time > 0) {
    capture.motion = [this, t = stamp](double time) { return motion_.path(t + time); };
  }
  capture.channels = options_.depth.is_apart() ? Channels{.depth = false} : depth_channels();
  return capture;
}

/// Returns the channels of colour and of all that depth is measured from.
Channels SequenceCamera::depth_channels() const {
  const bool has_multipath = options_.depth.multipath.is_on();
  return {.normal = true, .sight = sees_materials_ || has_multipath, .multipath = has_multipath};
}

Capture SequenceCamera::depth_capture(std::size_t index) const {
  const DepthSensorOptions& depth = options_.depth;
  Capture capture = color_capture(index);
  capture.channels = depth_channels();
  capture.channels.color = false;
  if (depth.is_elsewhere()) {
    capture.camera = registered_to(camera_).without_distortion();
  }
  const double stamp = motion_.truth[index].timestamp + depth.delay;
  capture.scene_time += depth.delay;
  capture.motion = [this, stamp, T_color_depth = depth.T_color_depth()](double time) {
    return motion_.path(stamp + time) * T_color_depth;
  };
  capture.shutter.exposure_time = 0;
  if (depth.shutter == DepthShutter::global) {
    capture.shutter.readout_time = 0;
  }
  return capture;
}

TimeSpan SequenceCamera::span(std::size_t index) const {
  const TimeSpan color = span_of(color_capture(index));
  const TimeSpan depth = span_of(depth_capture(index));
  return {std::min(color.begin, depth.begin), std::max(color.end, depth.end)};
}

vo::RgbdFrame SequenceCamera::take(std::size_t index, const Renderer& now,
                                   const RenderedFrame& color) const {
  vo::RgbdFrame frame{.timestamp = motion_.truth[index].timestamp,
                      .image = develop(color.radiance, camera_, options_, settings_[index])};
  const bool apart = options_.depth.is_apart();
  const Capture capture = apart ? depth_capture(index) : color_capture(index);
  const RenderedFrame ideal = apart ? now.render(capture) : color;
  const DepthView view = seen_by_depth_camera(
      with_multipath(ideal, capture.camera, options_.depth.multipath), options_.depth.materials);
  frame.depth = measure_depth(view, capture.camera, options_, index);
  if (options_.depth.is_elsewhere()) {
    frame.depth = registered(frame.depth, registered_to(camera_), options_.depth.T_color_depth());
  }
  frame.depth = without_dark(frame.depth, frame.image, options_.depth.holes.dark_level);
  return frame;
}

}  // namespace synth
