#include "vo/recording_files/mcap_index.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "vo/archives/crc32.h"
#include "vo/core/error.h"
#include "vo/recording_files/byte_cursor.h"
#include "vo/recording_files/mcap_records.h"

namespace vo {
namespace {

constexpr std::uint64_t kFooterSize = 20;
constexpr std::uint64_t kMaxDescription = 16'000'000;  // bytes of a schema, channel or index
constexpr std::uint64_t kChunkHead = 8 + 8 + 8 + 4;    // bytes before a chunk's compression
constexpr std::uint64_t kLongestCompression = 64;      // bytes of a compression's name
constexpr std::uint64_t kSummaryStep = 16'000'000;     // bytes of the summary read at once

/// Names of schemas by their number, which channels refer to.
using Schemas = std::map<std::uint16_t, std::string>;

/// Takes what the records of an MCAP file say of its topics into an index.
class McapTopics {
 public:
  McapTopics(RecordingIndex& index, const RangedFile& file) : index_(index), file_(file) {}

  /// Takes a schema or a channel; other records are left alone.
  void take(const RecordBytes& bytes, const McapRecord& record) {
    if (record.opcode == McapOpcode::schema) {
      const std::string content = description(bytes, record);
      ByteCursor cursor(content);
      const auto id = cursor.number<std::uint16_t>();
      schemas_[id] = cursor.counted();
    } else if (record.opcode == McapOpcode::channel) {
      take_channel(description(bytes, record));
    }
  }

 private:
  std::string description(const RecordBytes& bytes, const McapRecord& record) const {
    require(record.size <= kMaxDescription, file_.path().string(), ": the description at byte ",
            record.begin, " has ", record.size, " bytes, expected at most ", kMaxDescription);
    return bytes.read(record.content, record.size);
  }

  void take_channel(const std::string& content) {
    ByteCursor cursor(content);
    const auto id = cursor.number<std::uint16_t>();
    const auto schema = schemas_.find(cursor.number<std::uint16_t>());
    RecordedTopic topic{std::string(cursor.counted()),
                        schema == schemas_.end() ? "" : schema->second,
                        std::string(cursor.counted())};
    add_channel(index_, id, std::move(topic));
  }

  RecordingIndex& index_;
  const RangedFile& file_;
  Schemas schemas_;
};

/// Returns the part that a chunk is. Throws Error for a compression that is not known.
RecordingPart part_of_chunk(const RangedFile& file, const McapRecord& record) {
  const std::string place = concat(file.path().string(), ": the chunk at byte ", record.begin);
  const std::string head =
      file.read(record.content, std::min(record.size, kChunkHead + 4 + kLongestCompression + 8));
  try {
    ByteCursor cursor(head);
    cursor.take(2 * sizeof(std::uint64_t));  // the times of its first and last message
    RecordingPart part;
    part.size = cursor.number<std::uint64_t>();
    part.crc = cursor.number<std::uint32_t>();
    part.compression = compression_named(cursor.counted(), place);
    part.stored_size = cursor.number<std::uint64_t>();
    part.offset = record.content + cursor.position();
    require(part.stored_size <= record.size - cursor.position(), "states ", part.stored_size,
            " bytes of records, expected at most ", record.size - cursor.position());
    return part;
  } catch (const Error& error) {
    const std::string text = error.what();
    fail(text.starts_with(place) ? text : concat(place, " ", text));
  }
}

/// The end of a file that was closed.
struct Footer {
  std::uint64_t begin = 0;          ///< of its record
  std::uint64_t summary_begin = 0;  ///< 0: there is no summary
  std::uint32_t crc = 0;            ///< of the summary; 0 is unknown
};

std::optional<Footer> read_footer(const RangedFile& file) {
  const std::uint64_t size = kMcapRecordHead + kFooterSize + kMcapMagic.size();
  if (file.size() < size + kMcapMagic.size()) {
    return std::nullopt;
  }
  Footer footer{.begin = file.size() - size};
  const std::string bytes = file.read(footer.begin, size);
  ByteCursor cursor(bytes);
  const bool is_footer = cursor.number<McapOpcode>() == McapOpcode::footer &&
                         cursor.number<std::uint64_t>() == kFooterSize &&
                         bytes.ends_with(kMcapMagic);
  if (!is_footer) {
    return std::nullopt;
  }
  footer.summary_begin = cursor.number<std::uint64_t>();
  cursor.take(sizeof(std::uint64_t));  // where the summary's own index begins
  footer.crc = cursor.number<std::uint32_t>();
  const bool is_usable = footer.summary_begin == 0 || (footer.summary_begin >= kMcapMagic.size() &&
                                                       footer.summary_begin <= footer.begin);
  return is_usable ? std::optional(footer) : std::nullopt;
}

/// Returns whether the summary is as its CRC says, which covers the footer but for the CRC itself.
bool is_intact(const RangedFile& file, const Footer& footer) {
  const std::uint64_t end = footer.begin + kMcapRecordHead + 2 * sizeof(std::uint64_t);
  std::uint32_t crc = 0;
  for (std::uint64_t at = footer.summary_begin; at < end; at += kSummaryStep) {
    crc = crc32_of(file.read(at, std::min(kSummaryStep, end - at)), crc);
  }
  return footer.crc == 0 || crc == footer.crc;
}

/// A chunk as the summary has it.
struct IndexedChunk {
  std::uint64_t begin = 0;  ///< of its record
  std::uint64_t end = 0;    ///< of the index of its messages, behind it
  std::vector<std::uint32_t> channels;
};

IndexedChunk parse_chunk_index(const std::string& content) {
  ByteCursor cursor(content);
  cursor.take(2 * sizeof(std::uint64_t));
  IndexedChunk chunk;
  chunk.begin = cursor.number<std::uint64_t>();
  const auto size = cursor.number<std::uint64_t>();
  for (ByteCursor offsets(cursor.counted()); !offsets.at_end();) {
    chunk.channels.push_back(offsets.number<std::uint16_t>());
    offsets.take(sizeof(std::uint64_t));
  }
  const auto index_size = cursor.number<std::uint64_t>();
  chunk.end = chunk.begin + size + index_size;
  require(size >= kMcapRecordHead && chunk.end > chunk.begin && chunk.end - chunk.begin >= size,
          "states sizes that are too large");
  return chunk;
}

/// What a summary says.
struct Summary {
  std::vector<IndexedChunk> chunks;  ///< in the order of the file
  std::uint64_t chunk_count = 0;     ///< as its statistics have it
};

Summary read_summary(const RangedFile& file, const Footer& footer, McapTopics& topics) {
  Summary summary;
  const RecordBytes bytes = bytes_of(file);
  for_each_record(bytes, footer.summary_begin, footer.begin, [&](const McapRecord& record) {
    topics.take(bytes, record);
    const bool is_index = record.opcode == McapOpcode::chunk_index;
    if (is_index || record.opcode == McapOpcode::statistics) {
      require(record.size <= kMaxDescription, "has a record that is too large");
      const std::string content = bytes.read(record.content, record.size);
      ByteCursor cursor(content);
      if (is_index) {
        summary.chunks.push_back(parse_chunk_index(content));
      } else {
        cursor.take(8 + 2 + 4 + 4 + 4);
        summary.chunk_count = cursor.number<std::uint32_t>();
      }
    }
    return true;
  });
  std::sort(summary.chunks.begin(), summary.chunks.end(),
            [](const IndexedChunk& a, const IndexedChunk& b) { return a.begin < b.begin; });
  return summary;
}

void set_topics(RecordingPart& part, const std::vector<std::uint32_t>& channels,
                const RecordingIndex& index) {
  for (const std::uint32_t channel : channels) {
    if (const auto found = index.channels.find(channel); found != index.channels.end()) {
      part.topics.push_back(found->second);
    }
  }
  std::sort(part.topics.begin(), part.topics.end());
  part.has_topics = !channels.empty();
}

/// Returns the chunk's record, whose place and size the summary states.
McapRecord chunk_record(const RangedFile& file, const IndexedChunk& chunk, std::uint64_t end) {
  McapRecord found;
  for_each_record(bytes_of(file), chunk.begin, std::min(chunk.end, end),
                  [&](const McapRecord& record) {
                    found = record;
                    return false;
                  });
  require(found.opcode == McapOpcode::chunk, "has no chunk at byte ", chunk.begin);
  return found;
}

/// Returns the index that a summary gives; nothing where it lacks chunks. Between chunks, messages
/// may lie in the file itself.
std::optional<RecordingIndex> index_by_summary(const RangedFile& file, const Footer& footer) {
  RecordingIndex index;
  McapTopics topics(index, file);
  const Summary summary = read_summary(file, footer, topics);
  if (summary.chunks.empty() || summary.chunk_count != summary.chunks.size()) {
    return std::nullopt;
  }
  std::uint64_t at = kMcapMagic.size();
  const auto add_between = [&](std::uint64_t end) {
    if (end > at) {
      index.parts.push_back({.offset = at, .stored_size = end - at, .size = end - at});
    }
  };
  for (const IndexedChunk& chunk : summary.chunks) {
    require(chunk.begin >= at && chunk.end <= footer.summary_begin, "has chunks that overlap");
    add_between(chunk.begin);
    RecordingPart part = part_of_chunk(file, chunk_record(file, chunk, footer.summary_begin));
    set_topics(part, chunk.channels, index);
    index.parts.push_back(std::move(part));
    at = chunk.end;
  }
  add_between(footer.summary_begin);
  return index;
}

/// Takes the topics that a chunk describes and notes which of them it has messages of.
void describe_chunk(const RangedFile& file, RecordingPart& part, RecordingIndex& index,
                    McapTopics& topics) {
  const std::string chunk = read_part(file, part);
  const RecordBytes bytes = bytes_of(chunk);
  std::vector<std::uint32_t> channels;
  for_each_record(bytes, 0, bytes.size, [&](const McapRecord& record) {
    topics.take(bytes, record);
    if (record.opcode == McapOpcode::message && record.size >= kMcapMessageHead) {
      const std::string id = bytes.read(record.content, sizeof(std::uint16_t));
      const std::uint32_t channel = ByteCursor(id).number<std::uint16_t>();
      if (std::find(channels.begin(), channels.end(), channel) == channels.end()) {
        channels.push_back(channel);
      }
    }
    return true;
  });
  set_topics(part, channels, index);
}

/// Returns the index of a file by reading it from its begin to its end, or to where it is cut.
RecordingIndex index_by_scan(const RangedFile& file) {
  RecordingIndex index;
  McapTopics topics(index, file);
  const RecordBytes bytes = bytes_of(file);
  bool is_closed = false;
  bool is_run = false;  // whether the last part is of messages in the file itself
  const std::uint64_t end =
      for_each_record(bytes, kMcapMagic.size(), bytes.size, [&](const McapRecord& record) {
        topics.take(bytes, record);
        if (record.opcode == McapOpcode::chunk) {
          RecordingPart part = part_of_chunk(file, record);
          describe_chunk(file, part, index, topics);
          index.parts.push_back(std::move(part));
          is_run = false;
        } else if (record.opcode == McapOpcode::message) {
          if (!is_run) {
            index.parts.push_back({.offset = record.begin});
            is_run = true;
          }
          RecordingPart& part = index.parts.back();
          part.size = record.content + record.size - part.offset;
          part.stored_size = part.size;
        }
        is_closed = record.opcode == McapOpcode::data_end || record.opcode == McapOpcode::footer;
        return !is_closed;
      });
  const std::uint64_t last = file.size() - std::min<std::uint64_t>(file.size(), kMcapMagic.size());
  if (!is_closed || file.read(last, kMcapMagic.size()) != kMcapMagic) {
    index.notes.push_back(concat(file.path().string(), ": is cut at byte ", end, " of ",
                                 file.size(), "; what is whole before it is read"));
  }
  return index;
}

}  // namespace

std::uint64_t for_each_record(const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
                              const std::function<bool(const McapRecord& record)>& visit) {
  std::uint64_t at = begin;
  while (at < end && end - at >= kMcapRecordHead) {
    const std::string head = bytes.read(at, kMcapRecordHead);
    if (head.size() < kMcapRecordHead) {
      break;
    }
    ByteCursor cursor(head);
    McapRecord record{.opcode = cursor.number<McapOpcode>(),
                      .begin = at,
                      .content = at + kMcapRecordHead,
                      .size = cursor.number<std::uint64_t>()};
    if (record.size > end - record.content) {
      break;
    }
    at = record.content + record.size;
    if (!visit(record)) {
      break;
    }
  }
  return at;
}

RecordingIndex index_mcap(const RangedFile& file) {
  const std::optional<Footer> footer = read_footer(file);
  if (!footer || footer->summary_begin == 0) {
    return index_by_scan(file);
  }
  std::string problem = "is not as its CRC-32 says";
  if (is_intact(file, *footer)) {
    try {
      if (std::optional<RecordingIndex> index = index_by_summary(file, *footer)) {
        return std::move(*index);
      }
      problem.clear();
    } catch (const Error& error) {
      problem = error.what();
    }
  }
  RecordingIndex index = index_by_scan(file);
  if (!problem.empty()) {
    index.notes.insert(index.notes.begin(),
                       concat(file.path().string(), ": its summary cannot be used (", problem,
                              "), so all of it was read"));
  }
  return index;
}

void for_each_mcap_message(
    const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
    const std::function<bool(std::uint32_t channel, const RecordedMessage& message)>& visit) {
  for_each_record(bytes, begin, end, [&](const McapRecord& record) {
    if (record.opcode != McapOpcode::message) {
      return true;
    }
    require(record.size >= kMcapMessageHead && record.size - kMcapMessageHead <= kMaxPartBytes,
            "the message at byte ", record.begin, " has ", record.size, " bytes, expected ",
            kMcapMessageHead, " to ", kMaxPartBytes);
    const std::string head = bytes.read(record.content, kMcapMessageHead);
    ByteCursor cursor(head);
    const std::uint32_t channel = cursor.number<std::uint16_t>();
    cursor.take(sizeof(std::uint32_t));  // its number in a sequence
    RecordedMessage message;
    message.time_ns = cursor.number<std::uint64_t>();
    message.offset = record.content + kMcapMessageHead;
    message.size = static_cast<std::uint32_t>(record.size - kMcapMessageHead);
    return visit(channel, message);
  });
}

}  // namespace vo
