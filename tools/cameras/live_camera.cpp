#include "tools/cameras/live_camera.h"

#include <string_view>

#include "vo/core/error.h"

#ifdef EDVO_HAS_OPENNI2
#include "tools/cameras/openni2_camera.h"
#endif

namespace tools {
namespace {

constexpr std::string_view kOpenni2 = "openni2";

}  // namespace

bool is_live_camera(const std::string& name) {
  return name == kOpenni2 || name.starts_with(std::string(kOpenni2) + ":");
}

LiveCamera open_live_camera(const std::string& name, const LiveCameraSettings& settings) {
  vo::require(is_live_camera(name), name, ": is no camera, expected openni2 or openni2:URI");
#ifdef EDVO_HAS_OPENNI2
  return open_openni2_camera(name, name.substr(std::min(kOpenni2.size() + 1, name.size())),
                             settings);
#else
  vo::fail(name, ": this program was built without OpenNI2, expected a build with libopenni2-dev");
#endif
}

}  // namespace tools
