#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vo/recording_files/compression.h"
#include "vo/recording_files/mcap_records.h"

namespace vo {

/// How an MCAP file is laid out.
struct McapLayout {
  Compression compression = Compression::zstd;
  std::size_t chunk_bytes = 4'000'000;  ///< of a chunk, after which it is closed, decompressed
};

/// Writes an MCAP file of ROS 2's messages (profile ros2, CDR, definitions as ros2msg) in chunks,
/// with the index of their messages and a summary, each with its CRC-32. Equal calls give equal
/// bytes.
class McapWriter {
 public:
  using Sink = std::function<void(std::string_view bytes)>;

  McapWriter(Sink sink, const McapLayout& layout);

  /// Adds a topic; `type` is as ROS 2 writes it, `sensor_msgs/msg/Image`, `definition` what ros2msg
  /// has of it. Returns the number by which messages are written.
  std::uint16_t add_topic(const std::string& name, const std::string& type,
                          const std::string& definition);

  /// Writes a message in CDR, recorded and published at a time.
  void write(std::uint16_t topic, std::int64_t time_ns, std::string_view data);

  /// Writes what is left, and the summary.
  void finish();

 private:
  /// The messages of a topic in the open chunk: their times and places.
  using MessageIndex = std::map<std::uint16_t, std::vector<std::pair<std::int64_t, std::uint64_t>>>;

  void put(std::string_view bytes);
  void close_chunk();
  std::map<std::uint16_t, std::uint64_t> put_message_index();
  std::string statistics() const;
  std::string summary_groups();
  void put_data_end();

  Sink sink_;
  McapLayout layout_;
  std::uint64_t written_ = 0;   ///< bytes
  std::uint32_t data_crc_ = 0;  ///< of all that was written
  std::string chunk_;           ///< records of the open chunk
  std::int64_t chunk_begin_ns_ = 0;
  std::int64_t chunk_end_ns_ = 0;
  MessageIndex chunk_index_;
  std::map<std::string, std::uint16_t> schemas_;  ///< numbers by type
  std::string schema_records_;
  std::string channel_records_;
  std::string chunk_index_records_;
  std::map<std::uint16_t, std::uint64_t> counts_;  ///< messages of each topic
  std::uint32_t chunks_ = 0;
  std::int64_t begin_ns_ = 0;
  std::int64_t end_ns_ = 0;
};

}  // namespace vo
