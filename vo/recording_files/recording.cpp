#include "vo/recording_files/recording.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "vo/core/error.h"
#include "vo/core/nanoseconds.h"
#include "vo/recording_files/bag_index.h"
#include "vo/recording_files/mcap_index.h"
#include "vo/recording_files/mcap_records.h"

namespace vo {
namespace {

constexpr std::size_t kKeptParts = 4;
constexpr std::size_t kKeptBytes = 256'000'000;

std::optional<RecordingFormat> format_of(const RangedFile& file) {
  const std::string begin = file.read(0, kBagMagic.size());
  if (begin.starts_with(kMcapMagic)) {
    return RecordingFormat::mcap;
  }
  return begin == kBagMagic ? std::optional(RecordingFormat::bag) : std::nullopt;
}

RecordingIndex index_of(const RangedFile& file) {
  const std::optional<RecordingFormat> format = format_of(file);
  require(format.has_value(), "is no recording, expected an MCAP file or a ROS 1 bag (2.0)");
  return *format == RecordingFormat::mcap ? index_mcap(file) : index_bag(file);
}

/// Calls; an Error gets the file's path in front unless it has it.
template <typename Call>
auto naming(const std::filesystem::path& path, Call call) {
  try {
    return call();
  } catch (const Error& error) {
    const std::string text = error.what();
    throw Error(text.starts_with(path.string()) ? text : concat(path.string(), ": ", text),
                error.kind());
  }
}

std::size_t size_of(
    const std::list<std::pair<std::uint32_t, std::shared_ptr<const std::string>>>& parts) {
  std::size_t size = 0;
  for (const auto& [index, bytes] : parts) {
    size += bytes->size();
  }
  return size;
}

}  // namespace

std::optional<RecordingFormat> recording_format(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) ? format_of(RangedFile(path))
                                                         : std::nullopt;
}

Recording::Recording(const std::filesystem::path& path)
    : file_(path), index_(naming(path, [&] { return index_of(file_); })) {}

Recording::Bytes Recording::decompressed(std::uint32_t part) const {
  {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(latest_.begin(), latest_.end(),
                                    [&](const auto& kept) { return kept.first == part; });
    if (found != latest_.end()) {
      latest_.splice(latest_.begin(), latest_, found);
      return latest_.front().second;
    }
  }
  Bytes bytes = std::make_shared<const std::string>(read_part(file_, index_.parts.at(part)));
  const std::scoped_lock lock(mutex_);
  latest_.emplace_front(part, bytes);
  while (latest_.size() > 1 && (latest_.size() > kKeptParts || size_of(latest_) > kKeptBytes)) {
    latest_.pop_back();
  }
  return bytes;
}

void Recording::visit_part(std::uint32_t number, const std::vector<bool>& is_wanted, bool& goes_on,
                           const Visitor& visit) const {
  const RecordingPart& part = index_.parts[number];
  const bool is_in_file = part.compression == Compression::none;
  const Bytes chunk = is_in_file ? nullptr : decompressed(number);
  const RecordBytes bytes = is_in_file ? bytes_of(file_) : bytes_of(*chunk);
  const std::uint64_t begin = is_in_file ? part.offset : 0;
  const auto take = [&](std::uint32_t channel, const RecordedMessage& found) {
    const auto topic = index_.channels.find(channel);
    if (topic != index_.channels.end() && is_wanted[topic->second]) {
      RecordedMessage message = found;
      message.part = number;
      message.topic = topic->second;
      goes_on = visit(
          message, bytes.read(message.offset, std::min<std::uint64_t>(message.size, kHeadBytes)));
    }
    return goes_on;
  };
  if (index_.format == RecordingFormat::mcap) {
    for_each_mcap_message(bytes, begin, begin + part.size, take);
  } else {
    for_each_bag_message(bytes, begin, begin + part.size, take);
  }
}

bool Recording::may_have_messages(std::uint32_t topic) const {
  return std::any_of(index_.parts.begin(), index_.parts.end(), [&](const RecordingPart& part) {
    return !part.has_topics ||
           std::find(part.topics.begin(), part.topics.end(), topic) != part.topics.end();
  });
}

void Recording::for_each_message(const std::vector<std::uint32_t>& topics,
                                 const Visitor& visit) const {
  std::vector<bool> is_wanted(index_.topics.size());
  for (const std::uint32_t topic : topics) {
    is_wanted.at(topic) = true;
  }
  bool goes_on = true;
  naming(path(), [&] {
    for (std::uint32_t i = 0; i < index_.parts.size() && goes_on; ++i) {
      const RecordingPart& part = index_.parts[i];
      const bool has_some = std::any_of(part.topics.begin(), part.topics.end(),
                                        [&](std::uint32_t topic) { return is_wanted[topic]; });
      if (has_some || !part.has_topics) {
        visit_part(i, is_wanted, goes_on, visit);
      }
    }
  });
}

std::string Recording::read(const RecordedMessage& message) const {
  std::string bytes = index_.parts.at(message.part).compression == Compression::none
                          ? file_.read(message.offset, message.size)
                          : decompressed(message.part)->substr(message.offset, message.size);
  require(bytes.size() == message.size, place_of(message), ": has ", message.size,
          " bytes, of which ", bytes.size(), " are there");
  return bytes;
}

std::string Recording::place_of(const RecordedMessage& message) const {
  std::ostringstream text;
  text.precision(6);
  text << path().string() << ": " << topics()[message.topic].name << ", message of " << std::fixed
       << static_cast<double>(message.time_ns) / kNanosecondsPerSecond << " s";
  return text.str();
}

}  // namespace vo
