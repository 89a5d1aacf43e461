#pragma once

#include <string>

#include "tools/cameras/live_camera.h"
#include "vo/videos/video_library.h"

namespace tools {

/// Opens a camera of Video4Linux2, which has no depth: a device as /dev/video1, /dev/video0 if that
/// is empty. `name` begins what is said of it. Settings must have a camera, and without a size its
/// is asked for. Throws Error as `open_live_camera` does.
LiveCamera open_v4l2_camera(const std::string& name, const std::string& device,
                            const LiveCameraSettings& settings);

/// Returns the camera whose images a capture gives, by a thread of its own, at most 30 of them
/// before they are taken; what comes later or without a later stamp is missed. Throws Error where
/// the first image is not of the size of the settings and their camera, or does not come for 5 s.
LiveCamera live_camera_of(const std::string& name, const std::string& device,
                          vo::VideoCapture capture, const LiveCameraSettings& settings);

}  // namespace tools
