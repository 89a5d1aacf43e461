#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vo/files/ranged_file.h"
#include "vo/recording_files/recording_index.h"

namespace vo {

/// Returns the format of a recording by what a file begins with; none if it is no recording or no
/// file.
std::optional<RecordingFormat> recording_format(const std::filesystem::path& path);

/// A recording of messages, an MCAP file or a ROS 1 bag: it is indexed when it is opened, and its
/// messages are read one at a time, by any thread. Of decompressed chunks the latest few are kept.
class Recording {
 public:
  /// Called with a message and the first bytes of its data, at most `kHeadBytes`; returns whether
  /// to go on.
  using Visitor = std::function<bool(const RecordedMessage& message, std::string_view head)>;

  static constexpr std::uint64_t kHeadBytes = 64;

  /// Throws Error naming the file if it is no recording or is damaged.
  explicit Recording(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return file_.path(); }
  RecordingFormat format() const { return index_.format; }
  const std::vector<RecordedTopic>& topics() const { return index_.topics; }
  const std::vector<std::string>& notes() const { return index_.notes; }

  /// Returns whether a topic may have messages: not of those that are described alone.
  bool may_have_messages(std::uint32_t topic) const;

  /// Visits the messages of topics, given by their index, in the order of the file.
  void for_each_message(const std::vector<std::uint32_t>& topics, const Visitor& visit) const;

  /// Returns the data of a message. Throws Error naming the file if it is damaged.
  std::string read(const RecordedMessage& message) const;

  /// Returns `file: topic, message at TIME s`, for errors.
  std::string place_of(const RecordedMessage& message) const;

 private:
  using Bytes = std::shared_ptr<const std::string>;

  Bytes decompressed(std::uint32_t part) const;
  void visit_part(std::uint32_t part, const std::vector<bool>& is_wanted, bool& goes_on,
                  const Visitor& visit) const;

  RangedFile file_;
  RecordingIndex index_;
  mutable std::mutex mutex_;
  mutable std::list<std::pair<std::uint32_t, Bytes>> latest_;  ///< parts, the latest first
};

}  // namespace vo
