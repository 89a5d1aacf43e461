#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "vo/recording_files/byte_writer.h"

namespace support {

/// A message of ROS 1 on its way into a bag.
struct BagMessage {
  std::string topic;
  std::string type;  ///< as `sensor_msgs/Image`
  std::int64_t time_ns = 0;
  std::string data;  ///< as ROS 1 serialises it
};

/// A field of a bag's record: `name=value` behind its length.
template <typename Number>
std::string bag_field(const std::string& name, Number value) {
  std::string number;
  vo::append_number(number, value);
  std::string field;
  vo::append_counted(field, name + "=" + number);
  return field;
}

inline std::string bag_text(const std::string& name, const std::string& value) {
  std::string field;
  vo::append_counted(field, name + "=" + value);
  return field;
}

inline std::string bag_record(const std::string& fields, const std::string& data) {
  std::string record;
  vo::append_counted(record, fields);
  vo::append_counted(record, data);
  return record;
}

/// A bag of version 2.0, from the format's description: one chunk for every `messages_a_chunk`
/// messages, which are not compressed, and an index.
inline std::string bag_of(const std::vector<BagMessage>& messages,
                          std::size_t messages_a_chunk = 4) {
  const auto op = [](int code) { return bag_field("op", static_cast<std::uint8_t>(code)); };
  std::map<std::string, std::uint32_t> connections;
  std::string connection_records;
  for (const BagMessage& message : messages) {
    if (connections.try_emplace(message.topic, connections.size()).second) {
      connection_records += bag_record(
          op(7) + bag_field("conn", connections[message.topic]) + bag_text("topic", message.topic),
          bag_text("topic", message.topic) + bag_text("type", message.type));
    }
  }
  constexpr std::size_t kHeaderSize = 4096;
  std::string body;
  std::string infos;
  std::uint32_t chunks = 0;
  for (std::size_t i = 0; i < messages.size(); ++chunks) {
    std::string chunk = chunks == 0 ? connection_records : "";
    std::map<std::uint32_t, std::uint32_t> counts;
    for (std::size_t n = 0; n < messages_a_chunk && i < messages.size(); ++n, ++i) {
      const std::uint32_t connection = connections[messages[i].topic];
      const auto time = static_cast<std::uint64_t>(messages[i].time_ns / 1'000'000'000) |
                        static_cast<std::uint64_t>(messages[i].time_ns % 1'000'000'000) << 32;
      chunk += bag_record(op(2) + bag_field("conn", connection) + bag_field("time", time),
                          messages[i].data);
      ++counts[connection];
    }
    const std::uint64_t position = std::string("#ROSBAG V2.0\n").size() + kHeaderSize + body.size();
    std::string entries;
    for (const auto& [connection, count] : counts) {
      vo::append_number(entries, connection);
      vo::append_number(entries, count);
    }
    infos += bag_record(op(6) + bag_field("chunk_pos", position), entries);
    body += bag_record(op(5) + bag_text("compression", "none") +
                           bag_field("size", static_cast<std::uint32_t>(chunk.size())),
                       chunk);
  }
  const std::uint64_t index = std::string("#ROSBAG V2.0\n").size() + kHeaderSize + body.size();
  const std::string fields =
      op(3) + bag_field("index_pos", index) +
      bag_field("conn_count", static_cast<std::uint32_t>(connections.size())) +
      bag_field("chunk_count", chunks);
  const std::string header = bag_record(fields, std::string(kHeaderSize - 8 - fields.size(), ' '));
  return "#ROSBAG V2.0\n" + header + body + connection_records + infos;
}

/// std_msgs/Header as ROS 1 serialises it.
inline std::string ros1_header(std::int64_t stamp_ns, const std::string& frame) {
  std::string bytes;
  vo::append_number(bytes, std::uint32_t{0});
  vo::append_number(bytes, static_cast<std::uint32_t>(stamp_ns / 1'000'000'000));
  vo::append_number(bytes, static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
  vo::append_counted(bytes, frame);
  return bytes;
}

/// An image of 8x6 px whose bytes are all `value`.
inline BagMessage bag_image(const std::string& topic, std::int64_t stamp_ns,
                            const std::string& encoding, std::uint32_t pixel_size, char value) {
  constexpr std::uint32_t kWidth = 8;
  constexpr std::uint32_t kHeight = 6;
  std::string bytes = ros1_header(stamp_ns, "/camera");
  vo::append_number(bytes, kHeight);
  vo::append_number(bytes, kWidth);
  vo::append_counted(bytes, encoding);
  vo::append_number(bytes, std::uint8_t{0});
  vo::append_number(bytes, kWidth * pixel_size);
  vo::append_counted(bytes, std::string(std::size_t{kWidth} * kHeight * pixel_size, value));
  return {topic, "sensor_msgs/Image", stamp_ns, bytes};
}

/// A PoseStamped at (x, 0, 0) without rotation.
inline BagMessage bag_pose(const std::string& topic, std::int64_t stamp_ns, double x) {
  std::string bytes = ros1_header(stamp_ns, "world");
  for (const double number : {x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) {
    vo::append_number(bytes, number);
  }
  return {topic, "geometry_msgs/PoseStamped", stamp_ns, bytes};
}

}  // namespace support
