#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "vo/files/output.h"
#include "vo/recording_files/mcap_writer.h"
#include "vo/recording_files/ros_encoding.h"

namespace support {

/// A message of ROS 2 on its way into a recording.
struct TestMessage {
  std::string topic;
  std::string type;  ///< as `sensor_msgs/msg/Image`
  std::int64_t time_ns = 0;
  std::string data;  ///< CDR
};

inline std::string mcap_of(const std::vector<TestMessage>& messages,
                           const vo::McapLayout& layout = {}) {
  std::string bytes;
  vo::McapWriter writer([&](std::string_view part) { bytes += part; }, layout);
  std::map<std::string, std::uint16_t> topics;
  for (const TestMessage& message : messages) {
    if (!topics.contains(message.topic)) {
      topics[message.topic] = writer.add_topic(message.topic, message.type, "uint8 unused\n");
    }
    writer.write(topics[message.topic], message.time_ns, message.data);
  }
  writer.finish();
  return bytes;
}

/// An image of one value in an encoding whose pixels have this type.
inline TestMessage image_message(const std::string& topic, std::int64_t stamp_ns,
                                 const std::string& encoding, const cv::Mat& pixels,
                                 const std::string& frame = "camera") {
  vo::RosImage image{.header = {stamp_ns, frame}};
  image.height = static_cast<std::uint32_t>(pixels.rows);
  image.width = static_cast<std::uint32_t>(pixels.cols);
  image.encoding = encoding;
  image.step = static_cast<std::uint32_t>(pixels.step[0]);
  image.data = {reinterpret_cast<const char*>(pixels.data), pixels.total() * pixels.elemSize()};
  return {topic, "sensor_msgs/msg/Image", stamp_ns, vo::encode_cdr(image)};
}

/// The pose (x, 0, 0) without rotation, of `child` in `parent`.
inline vo::RosPose pose_at_x(std::int64_t stamp_ns, double x, const std::string& parent = "world",
                             const std::string& child = "camera") {
  return {{stamp_ns, parent}, child, {x, 0, 0}, {0, 0, 0, 1}};
}

inline TestMessage pose_message(const std::string& topic, const vo::RosPose& pose) {
  return {topic, "geometry_msgs/msg/PoseStamped", pose.header.stamp_ns,
          vo::encode_pose_stamped(pose)};
}

inline TestMessage tf_message(const std::vector<vo::RosPose>& transforms,
                              const std::string& topic = "/tf") {
  return {topic, "tf2_msgs/msg/TFMessage", transforms.front().header.stamp_ns,
          vo::encode_tf(transforms)};
}

}  // namespace support
