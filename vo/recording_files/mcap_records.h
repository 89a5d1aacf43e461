#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "vo/recording_files/recording_index.h"

namespace vo {

/// The kinds of records of an MCAP file (mcap.dev, version 0) that are read or written.
enum class McapOpcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// What an MCAP file begins and ends with.
inline constexpr std::string_view kMcapMagic("\x89MCAP0\r\n", 8);

inline constexpr std::uint64_t kMcapRecordHead = 9;  ///< bytes of a record's opcode and length

/// Bytes of a message before its data: channel, sequence number, two times.
inline constexpr std::uint64_t kMcapMessageHead = 2 + 4 + 8 + 8;

/// A record whose bytes are all there.
struct McapRecord {
  McapOpcode opcode{};
  std::uint64_t begin = 0;    ///< of the record
  std::uint64_t content = 0;  ///< begin of what follows opcode and length
  std::uint64_t size = 0;     ///< bytes of the content
};

/// Visits records in their order from `begin` to `end` while `visit` returns true. Returns where
/// the last one that is whole ends.
std::uint64_t for_each_record(const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
                              const std::function<bool(const McapRecord& record)>& visit);

}  // namespace vo
