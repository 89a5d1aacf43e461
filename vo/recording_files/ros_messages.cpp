#include "vo/recording_files/ros_messages.h"

#include <algorithm>

#include "vo/core/error.h"
#include "vo/core/nanoseconds.h"
#include "vo/recording_files/message_cursor.h"

namespace vo {
namespace {

std::int64_t parse_header_stamp(MessageCursor& cursor) {
  if (cursor.is_ros1()) {
    cursor.number<std::uint32_t>();  // a count of messages
    const std::int64_t seconds = cursor.number<std::uint32_t>();
    return seconds * kNanosecondsPerSecond + cursor.number<std::uint32_t>();
  }
  const std::int64_t seconds = cursor.number<std::int32_t>();
  return seconds * kNanosecondsPerSecond + cursor.number<std::uint32_t>();
}

std::string parse_frame(MessageCursor& cursor) {
  std::string frame = cursor.string();
  frame.erase(0, frame.starts_with('/') ? 1 : 0);  // tf of before 2010 has slashes
  return frame;
}

RosHeader parse_header(MessageCursor& cursor) {
  const std::int64_t stamp = parse_header_stamp(cursor);
  return {stamp, parse_frame(cursor)};
}

template <typename Numbers>
void parse_numbers(MessageCursor& cursor, Numbers& numbers) {
  for (double& number : numbers) {
    number = cursor.number<double>();
  }
}

RosPose parse_transform(MessageCursor& cursor) {
  RosPose pose{.header = parse_header(cursor)};
  pose.child_frame_id = parse_frame(cursor);
  parse_numbers(cursor, pose.position);
  parse_numbers(cursor, pose.rotation);
  return pose;
}

RosPose parse_pose(MessageCursor& cursor) {
  RosPose pose{.header = parse_header(cursor)};
  parse_numbers(cursor, pose.position);
  parse_numbers(cursor, pose.rotation);
  return pose;
}

}  // namespace

std::int64_t parse_stamp(std::string_view bytes, std::string_view encoding) {
  MessageCursor cursor(bytes, encoding);
  return parse_header_stamp(cursor);
}

RosImage parse_image(std::string_view bytes, std::string_view encoding) {
  MessageCursor cursor(bytes, encoding);
  RosImage image{.header = parse_header(cursor)};
  image.height = cursor.number<std::uint32_t>();
  image.width = cursor.number<std::uint32_t>();
  image.encoding = cursor.string();
  image.is_bigendian = cursor.number<std::uint8_t>() != 0;
  image.step = cursor.number<std::uint32_t>();
  image.data = cursor.bytes();
  return image;
}

RosCompressedImage parse_compressed_image(std::string_view bytes, std::string_view encoding) {
  MessageCursor cursor(bytes, encoding);
  RosCompressedImage image{.header = parse_header(cursor)};
  image.format = cursor.string();
  image.data = cursor.bytes();
  return image;
}

RosCameraInfo parse_camera_info(std::string_view bytes, std::string_view encoding) {
  MessageCursor cursor(bytes, encoding);
  RosCameraInfo info{.header = parse_header(cursor)};
  info.height = cursor.number<std::uint32_t>();
  info.width = cursor.number<std::uint32_t>();
  info.distortion_model = cursor.string();
  info.D.resize(cursor.count(sizeof(double)));
  parse_numbers(cursor, info.D);
  parse_numbers(cursor, info.K);
  parse_numbers(cursor, info.R);
  parse_numbers(cursor, info.P);
  return info;
}

bool holds_poses(std::string_view type) {
  constexpr std::array<std::string_view, 6> kTypes = {"geometry_msgs/PoseStamped",
                                                      "geometry_msgs/PoseWithCovarianceStamped",
                                                      "geometry_msgs/TransformStamped",
                                                      "nav_msgs/Odometry",
                                                      "tf2_msgs/TFMessage",
                                                      "tf/tfMessage"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

std::vector<RosPose> parse_poses(std::string_view bytes, std::string_view encoding,
                                 std::string_view type) {
  constexpr std::size_t kSmallestTransform = 64;  // bytes: stamp, two names, seven numbers
  MessageCursor cursor(bytes, encoding);
  std::vector<RosPose> poses;
  if (type == "tf2_msgs/TFMessage" || type == "tf/tfMessage") {
    for (std::uint32_t left = cursor.count(kSmallestTransform); left > 0; --left) {
      poses.push_back(parse_transform(cursor));
    }
  } else if (type == "geometry_msgs/TransformStamped") {
    poses.push_back(parse_transform(cursor));
  } else if (type == "nav_msgs/Odometry") {
    RosPose pose{.header = parse_header(cursor)};
    pose.child_frame_id = parse_frame(cursor);
    parse_numbers(cursor, pose.position);
    parse_numbers(cursor, pose.rotation);
    poses.push_back(std::move(pose));
  } else {
    require(holds_poses(type), "is a ", std::string(type), ", which holds no pose");
    poses.push_back(parse_pose(cursor));
  }
  return poses;
}

}  // namespace vo
