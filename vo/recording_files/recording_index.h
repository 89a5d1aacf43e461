#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vo/files/ranged_file.h"
#include "vo/recording_files/compression.h"

namespace vo {

/// The containers of recordings that are read.
enum class RecordingFormat { mcap, bag };

constexpr auto enum_names(RecordingFormat) {
  return std::array{std::pair{RecordingFormat::mcap, "mcap"},
                    std::pair{RecordingFormat::bag, "bag"}};
}

/// What the messages of one name and type are.
struct RecordedTopic {
  std::string name;      ///< as `/camera/color/image_raw`
  std::string type;      ///< as ROS 1 writes it: `sensor_msgs/Image`
  std::string encoding;  ///< of the messages: `cdr` (ROS 2), `ros1`, or what else the file says
};

/// A stretch of records with messages: a chunk, decompressed, or a part of the file itself.
struct RecordingPart {
  std::uint64_t offset = 0;       ///< in the file, of its bytes as they are stored
  std::uint64_t stored_size = 0;  ///< bytes
  std::uint64_t size = 0;         ///< bytes, decompressed
  Compression compression = Compression::none;
  std::uint32_t crc = 0;                ///< CRC-32 of the decompressed bytes; 0 is unknown
  bool has_topics = false;              ///< whether `topics` is known
  std::vector<std::uint32_t> topics{};  ///< indices of topics that it has messages of
};

/// Where the messages of a recording are.
struct RecordingIndex {
  RecordingFormat format = RecordingFormat::mcap;
  std::vector<RecordedTopic> topics;
  std::map<std::uint32_t, std::uint32_t> channels;  ///< index of the topic of a channel's number
  std::vector<RecordingPart> parts;                 ///< in the order of the file
  std::vector<std::string> notes;                   ///< sentences on what the file lacks
};

/// A message's place in a recording.
struct RecordedMessage {
  std::uint64_t time_ns = 0;  ///< when it was recorded
  std::uint64_t offset = 0;   ///< of its bytes in its part, decompressed
  std::uint32_t size = 0;     ///< bytes
  std::uint32_t part = 0;     ///< index in RecordingIndex::parts
  std::uint32_t topic = 0;    ///< index in RecordingIndex::topics
};

/// Bytes that records are read from: a file's or a decompressed part's.
struct RecordBytes {
  std::uint64_t size = 0;
  /// Returns `count` bytes from `offset` on, fewer where the bytes end before.
  std::function<std::string(std::uint64_t offset, std::uint64_t count)> read;
};

/// Returns the bytes of a file, which must outlive the result.
RecordBytes bytes_of(const RangedFile& file);

/// Returns bytes in memory, which must outlive the result.
RecordBytes bytes_of(const std::string& bytes);

/// The greatest size of a part that is compressed, and of a message, bytes.
inline constexpr std::uint64_t kMaxPartBytes = 1'000'000'000;

/// Returns the decompressed bytes of a part. Throws Error naming the file and the part's place if
/// they are damaged or more than `kMaxPartBytes`.
std::string read_part(const RangedFile& file, const RecordingPart& part);

/// Returns the compression of a name in a file; throws Error beginning with `place` if it is not
/// known.
Compression compression_named(std::string_view name, const std::string& place);

/// Adds a channel, and its topic unless another channel has it, too.
void add_channel(RecordingIndex& index, std::uint32_t channel, RecordedTopic topic);

}  // namespace vo
