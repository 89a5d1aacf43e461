#include "vo/recording_files/mcap_writer.h"

#include <algorithm>
#include <array>

#include "vo/archives/crc32.h"
#include "vo/core/fields.h"
#include "vo/core/version.h"
#include "vo/recording_files/byte_writer.h"

namespace vo {
namespace {

void append_record(std::string& bytes, McapOpcode opcode, std::string_view content) {
  append_number(bytes, opcode);
  append_number(bytes, static_cast<std::uint64_t>(content.size()));
  bytes += content;
}

/// Returns a compression's name as the format has it.
std::string_view stored_name(Compression compression) {
  return compression == Compression::none ? "" : to_string(compression);
}

}  // namespace

McapWriter::McapWriter(Sink sink, const McapLayout& layout)
    : sink_(std::move(sink)), layout_(layout) {
  std::string header;
  append_counted(header, "ros2");
  append_counted(header, std::string("edvo ") + version());
  std::string bytes(kMcapMagic);
  append_record(bytes, McapOpcode::header, header);
  put(bytes);
}

std::uint16_t McapWriter::add_topic(const std::string& name, const std::string& type,
                                    const std::string& definition) {
  const auto [schema, is_new] =
      schemas_.emplace(type, static_cast<std::uint16_t>(schemas_.size() + 1));
  if (is_new) {
    std::string content;
    append_number(content, schema->second);
    append_counted(content, type);
    append_counted(content, "ros2msg");
    append_counted(content, definition);
    append_record(schema_records_, McapOpcode::schema, content);
    append_record(chunk_, McapOpcode::schema, content);
  }
  const auto channel = static_cast<std::uint16_t>(counts_.size());
  counts_[channel] = 0;
  std::string content;
  append_number(content, channel);
  append_number(content, schema->second);
  append_counted(content, name);
  append_counted(content, "cdr");
  append_counted(content, "");  // nothing else
  append_record(channel_records_, McapOpcode::channel, content);
  append_record(chunk_, McapOpcode::channel, content);
  return channel;
}

void McapWriter::write(std::uint16_t topic, std::int64_t time_ns, std::string_view data) {
  const bool is_first = chunk_index_.empty();
  chunk_begin_ns_ = is_first ? time_ns : std::min(chunk_begin_ns_, time_ns);
  chunk_end_ns_ = is_first ? time_ns : std::max(chunk_end_ns_, time_ns);
  chunk_index_[topic].emplace_back(time_ns, chunk_.size());
  append_number(chunk_, McapOpcode::message);
  append_number(chunk_, kMcapMessageHead + data.size());
  append_number(chunk_, topic);
  append_number(chunk_, static_cast<std::uint32_t>(counts_[topic]++));
  append_number(chunk_, time_ns);
  append_number(chunk_, time_ns);
  chunk_ += data;
  if (chunk_.size() >= layout_.chunk_bytes) {
    close_chunk();
  }
}

void McapWriter::put(std::string_view bytes) {
  data_crc_ = crc32_of(bytes, data_crc_);
  written_ += bytes.size();
  sink_(bytes);
}

void McapWriter::close_chunk() {
  if (chunk_.empty()) {
    return;
  }
  const std::string stored = compress(layout_.compression, chunk_);
  std::string content;
  append_number(content, chunk_begin_ns_);
  append_number(content, chunk_end_ns_);
  append_number(content, static_cast<std::uint64_t>(chunk_.size()));
  append_number(content, crc32_of(chunk_));
  append_counted(content, stored_name(layout_.compression));
  append_number(content, static_cast<std::uint64_t>(stored.size()));
  content += stored;
  std::string record;
  append_record(record, McapOpcode::chunk, content);
  const std::uint64_t begin = written_;
  put(record);
  const std::uint64_t index_begin = written_;
  std::string offsets;
  for (const auto& [topic, offset] : put_message_index()) {
    append_number(offsets, topic);
    append_number(offsets, offset);
  }
  std::string index;
  append_number(index, chunk_begin_ns_);
  append_number(index, chunk_end_ns_);
  append_number(index, begin);
  append_number(index, static_cast<std::uint64_t>(record.size()));
  append_counted(index, offsets);
  append_number(index, written_ - index_begin);
  append_counted(index, stored_name(layout_.compression));
  append_number(index, static_cast<std::uint64_t>(stored.size()));
  append_number(index, static_cast<std::uint64_t>(chunk_.size()));
  append_record(chunk_index_records_, McapOpcode::chunk_index, index);
  begin_ns_ = chunks_ == 0 ? chunk_begin_ns_ : std::min(begin_ns_, chunk_begin_ns_);
  end_ns_ = chunks_ == 0 ? chunk_end_ns_ : std::max(end_ns_, chunk_end_ns_);
  ++chunks_;
  chunk_.clear();
  chunk_index_.clear();
}

std::map<std::uint16_t, std::uint64_t> McapWriter::put_message_index() {
  std::map<std::uint16_t, std::uint64_t> places;
  for (auto& [topic, messages] : chunk_index_) {
    std::stable_sort(messages.begin(), messages.end());
    std::string entries;
    for (const auto& [time_ns, offset] : messages) {
      append_number(entries, time_ns);
      append_number(entries, offset);
    }
    std::string content;
    append_number(content, topic);
    append_counted(content, entries);
    std::string record;
    append_record(record, McapOpcode::message_index, content);
    places[topic] = written_;
    put(record);
  }
  return places;
}

std::string McapWriter::statistics() const {
  std::uint64_t messages = 0;
  std::string counts;
  for (const auto& [topic, count] : counts_) {
    messages += count;
    append_number(counts, topic);
    append_number(counts, count);
  }
  std::string content;
  append_number(content, messages);
  append_number(content, static_cast<std::uint16_t>(schemas_.size()));
  append_number(content, static_cast<std::uint32_t>(counts_.size()));
  append_number(content, std::uint32_t{0});  // attachments
  append_number(content, std::uint32_t{0});  // metadata
  append_number(content, chunks_);
  append_number(content, begin_ns_);
  append_number(content, end_ns_);
  append_counted(content, counts);
  std::string record;
  append_record(record, McapOpcode::statistics, content);
  return record;
}

std::string McapWriter::summary_groups() {
  const std::array<std::pair<McapOpcode, std::string>, 4> groups = {
      std::pair{McapOpcode::schema, schema_records_},
      std::pair{McapOpcode::channel, channel_records_},
      std::pair{McapOpcode::statistics, statistics()},
      std::pair{McapOpcode::chunk_index, chunk_index_records_}};
  std::string summary;
  std::string offsets;
  for (const auto& [opcode, records] : groups) {
    if (!records.empty()) {
      std::string content;
      append_number(content, opcode);
      append_number(content, written_ + summary.size());
      append_number(content, static_cast<std::uint64_t>(records.size()));
      append_record(offsets, McapOpcode::summary_offset, content);
      summary += records;
    }
  }
  const std::uint64_t offsets_begin = written_ + summary.size();
  summary += offsets;
  append_number(summary, McapOpcode::footer);
  append_number(summary, std::uint64_t{20});  // bytes of the footer
  append_number(summary, written_);
  append_number(summary, offsets_begin);
  return summary;
}

void McapWriter::put_data_end() {
  std::string content;
  append_number(content, data_crc_);
  std::string record;
  append_record(record, McapOpcode::data_end, content);
  put(record);
}

void McapWriter::finish() {
  close_chunk();
  put_data_end();
  std::string summary = summary_groups();
  append_number(summary, crc32_of(summary));
  summary += kMcapMagic;
  put(summary);
}

}  // namespace vo
