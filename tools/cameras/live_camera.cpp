#include "tools/cameras/live_camera.h"

#include <algorithm>
#include <string_view>

#include "tools/cameras/v4l2_camera.h"
#include "vo/core/error.h"

#ifdef EDVO_HAS_OPENNI2
#include "tools/cameras/openni2_camera.h"
#endif

namespace tools {
namespace {

constexpr std::string_view kOpenni2 = "openni2";
constexpr std::string_view kV4l2 = "v4l2";

/// Returns whether a name is that of a kind of cameras, with or without the device behind a colon.
bool is_of(std::string_view kind, const std::string& name) {
  return name == kind || name.starts_with(std::string(kind) + ":");
}

/// Returns what stands behind the colon; empty without one.
std::string device_of(std::string_view kind, const std::string& name) {
  return name.substr(std::min(kind.size() + 1, name.size()));
}

}  // namespace

bool is_live_camera(const std::string& name) {
  return is_of(kOpenni2, name) || is_of(kV4l2, name);
}

LiveCamera open_live_camera(const std::string& name, const LiveCameraSettings& settings) {
  vo::require(is_live_camera(name), name,
              ": is no camera, expected openni2, openni2:URI, v4l2 or v4l2:DEVICE");
  if (is_of(kV4l2, name)) {
    return open_v4l2_camera(name, device_of(kV4l2, name), settings);
  }
#ifdef EDVO_HAS_OPENNI2
  return open_openni2_camera(name, device_of(kOpenni2, name), settings);
#else
  vo::fail(name, ": this program was built without OpenNI2, expected a build with libopenni2-dev");
#endif
}

}  // namespace tools
