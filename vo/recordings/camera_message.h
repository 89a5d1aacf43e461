#pragma once

#include <string>

#include "vo/geometry/camera.h"
#include "vo/recording_files/ros_messages.h"

namespace vo {

/// The images that a sensor_msgs/CameraInfo is read for.
enum class Rectification {
  none,      ///< as the lens images: K and D
  rectified  ///< without distortion: P
};

/// Returns the camera of images in a recording; 16-bit depth is in mm, as ROS has it. Throws Error
/// beginning with `place` if it is not calibrated or its lens is of a model that is not known
/// (plumb_bob, rational_polynomial as far as it is one, equidistant).
RgbdCamera camera_of(const RosCameraInfo& info, Rectification rectification,
                     const std::string& place);

/// Returns a camera as a message, of images that are not rectified, without a header.
RosCameraInfo camera_info_of(const PinholeCamera& camera);

}  // namespace vo
