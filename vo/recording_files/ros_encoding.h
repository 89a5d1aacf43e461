#pragma once

#include <string>
#include <vector>

#include "vo/recording_files/ros_messages.h"

namespace vo {

/// Messages of ROS 2 in CDR, plain and in little endian.
std::string encode_cdr(const RosImage& image);
std::string encode_cdr(const RosCameraInfo& info);
std::string encode_cdr(const RosPointCloud& cloud);
std::string encode_pose_stamped(const RosPose& pose);
std::string encode_tf(const std::vector<RosPose>& transforms);

/// Returns what a ROS 2 type that is written (`sensor_msgs/msg/Image`) consists of, in the language
/// of .msg files, and behind it, each after a line of `=`, the types that it uses.
std::string ros2_definition(const std::string& type);

}  // namespace vo
