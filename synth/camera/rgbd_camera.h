#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "synth/camera/metering.h"
#include "synth/camera/renderers_over_time.h"
#include "synth/path/camera_path.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/sensor/sensor.h"
#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// What a sensor is carried along.
struct SensorMotion {
  vo::Trajectory truth;  ///< T_world_camera at the stamp of each frame
  CameraPath path;       ///< and at any time between
};

/// The path through poses: a spline, at rest where there is only one.
CameraPath path_through(const vo::Trajectory& poses);

/// Takes the frames of a sequence, from any thread, in any order: each depends on its index and on
/// what it was made from alone. What it is made from must outlive it.
class RgbdSensor {
 public:
  /// Meters the whole sequence where exposure or white balance follow the scene.
  RgbdSensor(const Scene& scene, const RenderersOverTime& renderers,
             const vo::PinholeCamera& camera, const SensorMotion& motion,
             const SensorOptions& options);

  /// Stamped with the colour image's; depth's is `options.depth.delay` later.
  vo::RgbdFrame take(std::size_t index) const { return take(index, *renderer_at(index)); }

  /// When anything of a frame is measured, s after the first stamp.
  TimeSpan span(std::size_t index) const;

  /// With a renderer of the scene as it is during the frame.
  vo::RgbdFrame take(std::size_t index, const Renderer& now) const;

  const FrameSetting& setting(std::size_t index) const { return settings_[index]; }

 private:
  void follow_exposure(const std::vector<Metering>& metered);
  void follow_balance(const std::vector<Metering>& metered);
  std::vector<Metering> meter_frames() const;
  std::shared_ptr<const Renderer> renderer_at(std::size_t index) const;
  std::vector<double> stamps() const;
  Capture color_capture(std::size_t index) const;
  Capture depth_capture(std::size_t index) const;

  const RenderersOverTime& renderers_;
  const vo::PinholeCamera& camera_;
  const SensorMotion& motion_;
  SensorOptions options_;
  std::vector<FrameSetting> settings_;
};

}  // namespace synth
