#include "vo/recording_files/recording_index.h"

#include <algorithm>

#include "vo/archives/crc32.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace vo {

RecordBytes bytes_of(const RangedFile& file) {
  return {file.size(),
          [&file](std::uint64_t offset, std::uint64_t count) { return file.read(offset, count); }};
}

RecordBytes bytes_of(const std::string& bytes) {
  return {bytes.size(), [&bytes](std::uint64_t offset, std::uint64_t count) {
            return offset < bytes.size() ? bytes.substr(offset, count) : std::string();
          }};
}

std::string read_part(const RangedFile& file, const RecordingPart& part) {
  const std::string place = concat(file.path().string(), ": the chunk at byte ", part.offset);
  require(part.size <= kMaxPartBytes && part.stored_size <= kMaxPartBytes, place, " has ",
          part.size, " bytes, expected at most ", kMaxPartBytes);
  const std::string stored = file.read(part.offset, part.stored_size);
  require(stored.size() == part.stored_size, place, " ends early: expected ", part.stored_size,
          " bytes, got ", stored.size());
  try {
    std::string bytes = decompress(part.compression, stored, part.size);
    require(part.crc == 0 || crc32_of(bytes) == part.crc,
            "is damaged: its CRC-32 is not the one that was stored");
    return bytes;
  } catch (const Error& error) {
    fail(place, " ", error.what());
  }
}

Compression compression_named(std::string_view name, const std::string& place) {
  if (name.empty()) {
    return Compression::none;
  }
  const auto names = names_of<Compression>();
  require(std::find(names.begin(), names.end(), name) != names.end(), place, " is compressed by '",
          std::string(name.substr(0, 32)), "', expected none, lz4, zstd or bz2");
  return parse_enum<Compression>(std::string(name));
}

void add_channel(RecordingIndex& index, std::uint32_t channel, RecordedTopic topic) {
  if (const std::size_t at = topic.type.find("/msg/"); at != std::string::npos) {
    topic.type.erase(at, 4);  // ROS 2's form
  }
  const auto same =
      std::find_if(index.topics.begin(), index.topics.end(), [&](const RecordedTopic& other) {
        return other.name == topic.name && other.type == topic.type &&
               other.encoding == topic.encoding;
      });
  index.channels[channel] = static_cast<std::uint32_t>(same - index.topics.begin());
  if (same == index.topics.end()) {
    index.topics.push_back(std::move(topic));
  }
}

}  // namespace vo
