#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "synth/camera/metering.h"
#include "synth/camera/renderers_over_time.h"
#include "synth/path/camera_path.h"
#include "synth/rendering/infrared.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/sensor/sensor.h"
#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// The motion of a sensor during a sequence, and when that is in the scene's time.
struct CameraTruth {
  vo::Trajectory truth;    ///< T_world_camera at the stamp of each frame
  CameraPath path;         ///< T_world_camera at any time between the stamps
  double scene_delay = 0;  ///< s, the time of the scene's animations at the first stamp
};

/// Returns the spline path through poses, or a path at rest for fewer than two poses.
CameraPath path_through(const vo::Trajectory& poses);

/// Returns whether what a sensor's depth camera makes of materials shows in a scene.
bool sees_materials(const Scene& scene, const SensorOptions& options);

/// Takes the frames of a sequence, from any thread and in any order: each depends only on its index
/// and the constructor's arguments. `renderers` and `motion` must outlive the sensor.
class SequenceCamera {
 public:
  /// Meters the scene where `options.exposure` is 0, and every frame where exposure or white
  /// balance are automatic. `infrared` is how an infrared camera sees; none: it sees colours.
  SequenceCamera(const Scene& scene, const RenderersOverTime& renderers,
                 const vo::CameraModel& camera, const CameraTruth& motion,
                 const SensorOptions& options, std::optional<InfraredBand> infrared = std::nullopt);

  /// Takes a frame, stamped with the colour image's time; depth is `options.depth.delay` later.
  vo::RgbdFrame take(std::size_t index) const { return take(index, *renderer_at(index)); }

  /// Returns the time span, s after the first stamp, in which a frame is exposed.
  TimeSpan span(std::size_t index) const;

  /// Takes a frame with a renderer of the scene as it is during the frame.
  vo::RgbdFrame take(std::size_t index, const Renderer& now) const {
    return take(index, now, now.render(color_capture(index)));
  }

  /// Takes a frame of which `color` is what was rendered of its `color_capture`.
  vo::RgbdFrame take(std::size_t index, const Renderer& now, const RenderedFrame& color) const;

  /// Returns the capture of a frame's colour, and of its depth if that is seen from the same place
  /// at the same time.
  Capture color_capture(std::size_t index) const;

  /// Returns a renderer of the scene as it is at a frame's stamp.
  std::shared_ptr<const Renderer> renderer_at(std::size_t index) const;

  const FrameSetting& setting(std::size_t index) const { return settings_[index]; }

 private:
  void follow_exposure(const std::vector<Metering>& metered);
  void follow_balance(const std::vector<Metering>& metered);
  std::vector<Metering> meter_frames() const;
  double scene_time_of(std::size_t index) const;
  std::vector<double> stamps() const;
  Channels depth_channels() const;
  Capture depth_capture(std::size_t index) const;

  const RenderersOverTime& renderers_;
  vo::CameraModel camera_;
  const CameraTruth& motion_;
  SensorOptions options_;
  std::optional<InfraredBand> infrared_;
  bool sees_materials_;
  std::vector<FrameSetting> settings_;
};

}  // namespace synth
