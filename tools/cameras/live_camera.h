#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Settings with which a user opens a camera that runs.
struct LiveCameraSettings {
  std::optional<vo::RgbdCamera> camera;     ///< in the place of what the device says of its lens
  std::optional<std::pair<int, int>> size;  ///< px, width and height of the images
  double max_time_difference = 0.02;        ///< s, between colour and depth of a frame
};

/// A camera that is read while it runs. It runs as long as a copy of this lives.
struct LiveCamera {
  std::string device;  ///< as the device calls itself
  vo::RgbdCamera camera;
  bool has_depth = true;  ///< else frames are images alone

  /// Waits for the next frame and returns it; nothing once the callback, asked at least every tenth
  /// of a second, says that it is to stop, or where the device has no more. Throws Error of kind
  /// temporary where nothing arrives for 5 s.
  std::function<std::optional<vo::RgbdFrame>(const std::function<bool()>& is_stopped)> next;

  std::function<std::size_t()> missed;  ///< frames that the device had and nobody took in time
  std::vector<std::string> notes;       ///< sentences on what a user of the frames must know
};

/// Returns whether a name is that of a camera that runs: `openni2`, its first device, or
/// `openni2:URI`; `v4l2`, which is /dev/video0, or `v4l2:DEVICE`.
bool is_live_camera(const std::string& name);

/// Opens and starts a camera. Throws Error naming it where there is none, where one of OpenNI2's
/// has not colour and depth of one size, or where this program was built without its library.
LiveCamera open_live_camera(const std::string& name, const LiveCameraSettings& settings);

}  // namespace tools
