#pragma once

#include <string>

#include "tools/cameras/live_camera.h"

namespace tools {

/// Opens the RGB-D camera of a URI, or the first one if it is empty, by OpenNI2: its depth
/// registered to its colour and both taken together, where the device can. Errors name it `name`.
LiveCamera open_openni2_camera(const std::string& name, const std::string& uri,
                               const LiveCameraSettings& settings);

}  // namespace tools
