#include "vo/recording_files/bag_index.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/nanoseconds.h"
#include "vo/recording_files/byte_cursor.h"

namespace vo {
namespace {

constexpr std::uint64_t kMaxHeader = 1'000'000;       // bytes of a record's fields
constexpr std::uint64_t kMaxConnection = 16'000'000;  // bytes of a connection's fields
constexpr std::uint64_t kMaxChunkInfo = 16'000'000;   // bytes of the counts of a chunk

/// The kinds of records of a bag.
enum class BagOpcode : std::uint8_t {
  message = 0x02,
  bag_header = 0x03,
  message_index = 0x04,
  chunk = 0x05,
  chunk_info = 0x06,
  connection = 0x07,
};

/// A record whose bytes are all there.
struct BagRecord {
  std::uint64_t begin = 0;  ///< of the record
  std::string fields;       ///< each `name=value` behind its length
  std::uint64_t data = 0;   ///< begin of its data
  std::uint64_t size = 0;   ///< bytes of its data

  /// Returns the value of a field; empty if there is none. Throws Error for fields that are cut.
  std::string_view field(std::string_view name) const { return field_of(fields, name); }

  static std::string_view field_of(std::string_view fields, std::string_view name) {
    for (ByteCursor cursor(fields); !cursor.at_end();) {
      const std::string_view field = cursor.counted();
      if (field.starts_with(name) && field.size() > name.size() && field[name.size()] == '=') {
        return field.substr(name.size() + 1);
      }
    }
    return {};
  }

  template <typename Number>
  Number number(std::string_view name) const {
    const std::string_view value = field(name);
    require(value.size() == sizeof(Number), "the record at byte ", begin, " has no ",
            std::string(name));
    return ByteCursor(value).number<Number>();
  }

  BagOpcode opcode() const { return number<BagOpcode>("op"); }
};

/// Visits the records that are whole from `begin` to `end` while `visit` returns true. Returns
/// where the last of them ends.
std::uint64_t for_each_bag_record(const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
                                  const std::function<bool(const BagRecord& record)>& visit) {
  std::uint64_t at = begin;
  while (at < end && end - at >= 2 * sizeof(std::uint32_t)) {
    const std::string length = bytes.read(at, sizeof(std::uint32_t));
    if (length.size() < sizeof(std::uint32_t)) {
      break;
    }
    const std::uint64_t header = ByteCursor(length).number<std::uint32_t>();
    require(header <= kMaxHeader, "the record at byte ", at, " has ", header,
            " bytes of fields, expected at most ", kMaxHeader);
    if (header > end - at - 2 * sizeof(std::uint32_t)) {
      break;
    }
    BagRecord record{.begin = at, .fields = bytes.read(at + length.size(), header + length.size())};
    if (record.fields.size() < header + length.size()) {
      break;
    }
    record.size =
        ByteCursor(std::string_view(record.fields).substr(header)).number<std::uint32_t>();
    record.fields.resize(header);
    record.data = at + header + 2 * sizeof(std::uint32_t);
    if (record.size > end - record.data) {
      break;
    }
    at = record.data + record.size;
    if (!visit(record)) {
      break;
    }
  }
  return at;
}

void take_connection(const RecordBytes& bytes, const BagRecord& record, RecordingIndex& index) {
  require(record.size <= kMaxConnection, "the connection at byte ", record.begin, " has ",
          record.size, " bytes, expected at most ", kMaxConnection);
  const std::string data = bytes.read(record.data, record.size);
  add_channel(
      index, record.number<std::uint32_t>("conn"),
      {std::string(record.field("topic")), std::string(BagRecord::field_of(data, "type")), "ros1"});
}

RecordingPart part_of_chunk(const RangedFile& file, const BagRecord& record) {
  RecordingPart part{.offset = record.data, .stored_size = record.size};
  part.size = record.number<std::uint32_t>("size");
  part.compression =
      compression_named(record.field("compression"),
                        concat(file.path().string(), ": the chunk at byte ", record.begin));
  require(part.compression != Compression::none || part.size == part.stored_size,
          "the chunk at byte ", record.begin, " states ", part.size, " bytes, expected the ",
          part.stored_size, " that it has");
  return part;
}

void set_connections(RecordingPart& part, const std::vector<std::uint32_t>& connections,
                     const RecordingIndex& index) {
  for (const std::uint32_t connection : connections) {
    if (const auto found = index.channels.find(connection); found != index.channels.end()) {
      part.topics.push_back(found->second);
    }
  }
  std::sort(part.topics.begin(), part.topics.end());
  part.has_topics = true;
}

/// A chunk as the bag's index has it.
struct ChunkInfo {
  std::uint64_t begin = 0;  ///< of the chunk's record
  std::vector<std::uint32_t> connections;
};

ChunkInfo parse_chunk_info(const RecordBytes& bytes, const BagRecord& record) {
  ChunkInfo info{.begin = record.number<std::uint64_t>("chunk_pos")};
  require(record.size <= kMaxChunkInfo, "the record at byte ", record.begin, " has ", record.size,
          " bytes, expected at most ", kMaxChunkInfo);
  const std::string data = bytes.read(record.data, record.size);
  for (ByteCursor cursor(data); !cursor.at_end();) {
    info.connections.push_back(cursor.number<std::uint32_t>());
    cursor.take(sizeof(std::uint32_t));  // how many messages
  }
  return info;
}

/// Returns the index that a bag ends with; nothing where it is not whole.
std::optional<RecordingIndex> index_by_end(const RangedFile& file, const BagRecord& header) {
  const auto begin = header.number<std::uint64_t>("index_pos");
  if (begin == 0 || begin >= file.size()) {
    return std::nullopt;
  }
  RecordingIndex index{.format = RecordingFormat::bag};
  std::vector<ChunkInfo> chunks;
  const RecordBytes bytes = bytes_of(file);
  const std::uint64_t end =
      for_each_bag_record(bytes, begin, file.size(), [&](const BagRecord& record) {
        if (record.opcode() == BagOpcode::connection) {
          take_connection(bytes, record, index);
        } else if (record.opcode() == BagOpcode::chunk_info) {
          chunks.push_back(parse_chunk_info(bytes, record));
        }
        return true;
      });
  if (end != file.size() || chunks.size() != header.number<std::uint32_t>("chunk_count")) {
    return std::nullopt;
  }
  std::sort(chunks.begin(), chunks.end(),
            [](const ChunkInfo& a, const ChunkInfo& b) { return a.begin < b.begin; });
  for (const ChunkInfo& chunk : chunks) {
    bool is_there = false;
    for_each_bag_record(bytes, chunk.begin, begin, [&](const BagRecord& record) {
      is_there = record.opcode() == BagOpcode::chunk;
      if (is_there) {
        index.parts.push_back(part_of_chunk(file, record));
        set_connections(index.parts.back(), chunk.connections, index);
      }
      return false;
    });
    require(is_there, "has no chunk at byte ", chunk.begin);
  }
  return index;
}

void describe_chunk(const RangedFile& file, RecordingPart& part, RecordingIndex& index) {
  const std::string chunk = read_part(file, part);
  const RecordBytes bytes = bytes_of(chunk);
  std::vector<std::uint32_t> connections;
  for_each_bag_record(bytes, 0, bytes.size, [&](const BagRecord& record) {
    if (record.opcode() == BagOpcode::connection) {
      take_connection(bytes, record, index);
    } else if (record.opcode() == BagOpcode::message) {
      const auto connection = record.number<std::uint32_t>("conn");
      if (std::find(connections.begin(), connections.end(), connection) == connections.end()) {
        connections.push_back(connection);
      }
    }
    return true;
  });
  set_connections(part, connections, index);
}

RecordingIndex index_by_reading(const RangedFile& file) {
  RecordingIndex index{.format = RecordingFormat::bag};
  const RecordBytes bytes = bytes_of(file);
  const std::uint64_t end =
      for_each_bag_record(bytes, kBagMagic.size(), file.size(), [&](const BagRecord& record) {
        if (record.opcode() == BagOpcode::connection) {
          take_connection(bytes, record, index);
        } else if (record.opcode() == BagOpcode::chunk) {
          RecordingPart part = part_of_chunk(file, record);
          describe_chunk(file, part, index);
          index.parts.push_back(std::move(part));
        }
        return true;
      });
  index.notes.push_back(end == file.size()
                            ? concat(file.path().string(),
                                     ": has no index (it was not closed), so all of it was read")
                            : concat(file.path().string(), ": is cut at byte ", end, " of ",
                                     file.size(), "; what is whole before it is read"));
  return index;
}

}  // namespace

RecordingIndex index_bag(const RangedFile& file) {
  std::optional<BagRecord> header;
  for_each_bag_record(bytes_of(file), kBagMagic.size(), file.size(), [&](const BagRecord& record) {
    header = record;
    return false;
  });
  require(header && header->opcode() == BagOpcode::bag_header, "has no header");
  require(header->field("encryptor").empty(), "is encrypted by ",
          std::string(header->field("encryptor")), ", expected a bag in the clear");
  if (std::optional<RecordingIndex> index = index_by_end(file, *header)) {
    return std::move(*index);
  }
  return index_by_reading(file);
}

void for_each_bag_message(
    const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
    const std::function<bool(std::uint32_t channel, const RecordedMessage& message)>& visit) {
  for_each_bag_record(bytes, begin, end, [&](const BagRecord& record) {
    if (record.opcode() != BagOpcode::message) {
      return true;
    }
    require(record.size <= kMaxPartBytes, "the message at byte ", record.begin, " has ",
            record.size, " bytes, expected at most ", kMaxPartBytes);
    RecordedMessage message;
    const auto time = record.number<std::uint64_t>("time");  // s, and ns in the upper half
    message.time_ns = static_cast<std::int64_t>(time & 0xFFFFFFFF) * kNanosecondsPerSecond +
                      static_cast<std::int64_t>(time >> 32);
    message.offset = record.data;
    message.size = static_cast<std::uint32_t>(record.size);
    return visit(record.number<std::uint32_t>("conn"), message);
  });
}

}  // namespace vo
