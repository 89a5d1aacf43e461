#include "vo/recordings/stamped_messages.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "vo/core/error.h"
#include "vo/motion_files/timestamp.h"
#include "vo/recording_files/ros_messages.h"

namespace vo {
namespace {

constexpr std::int64_t kMostDisorderNs = 500'000'000;

/// A message and the stamp in its header.
struct Found {
  std::int64_t stamp_ns = 0;
  RecordedMessage message;
};

/// Takes the times of recording where no message has a stamp.
void take_recorded_times(std::vector<Found>& found, const std::string& place,
                         std::vector<std::string>& notes) {
  constexpr auto kMostNs = static_cast<std::uint64_t>(kMaxTimestamp / kNanosecond);
  const bool has_stamps =
      std::any_of(found.begin(), found.end(), [](const Found& each) { return each.stamp_ns != 0; });
  if (has_stamps || found.empty()) {
    return;
  }
  for (Found& each : found) {
    require(each.message.time_ns <= kMostNs, place, ": expected times of recording within ",
            kMaxTimestamp, " s of 0");
    each.stamp_ns = static_cast<std::int64_t>(each.message.time_ns);
  }
  notes.push_back(place + ": its messages have no stamps; the times of recording are taken");
}

/// Sorts messages by their stamps.
void put_in_order(std::vector<Found>& found, const Recording& recording, const std::string& place,
                  std::vector<std::string>& notes) {
  std::int64_t latest = found.empty() ? 0 : found.front().stamp_ns;
  std::int64_t most = 0;
  std::size_t disordered = 0;
  for (const Found& each : found) {
    const std::int64_t back = latest - each.stamp_ns;
    if (back > kMostDisorderNs) {
      fail(recording.place_of(each.message),
           ": expected a stamp after the ones before it, or up to ", seconds_of(kMostDisorderNs),
           " s earlier, got one that is ", seconds_of(back), " s earlier");
    }
    disordered += back > 0 ? 1 : 0;
    most = std::max(most, back);
    latest = std::max(latest, each.stamp_ns);
  }
  if (disordered == 0) {
    return;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.stamp_ns < b.stamp_ns; });
  notes.push_back(concat(place, ": ", disordered, " of ", found.size(),
                         " messages came after later ones, by up to ", seconds_of(most),
                         " s; they were sorted"));
}

StampedMessages without_repeats(const std::vector<Found>& found, const std::string& place,
                                std::vector<std::string>& notes) {
  StampedMessages result;
  for (const Found& each : found) {
    const double timestamp = seconds_of(each.stamp_ns);
    if (result.timestamps.empty() || timestamp > result.timestamps.back()) {
      result.timestamps.push_back(timestamp);
      result.messages.push_back(each.message);
    }
  }
  if (result.messages.size() < found.size()) {
    notes.push_back(concat(place, ": ", found.size() - result.messages.size(), " of ", found.size(),
                           " messages have the stamp of another; the first of each stamp counts"));
  }
  return result;
}

}  // namespace

std::vector<StampedMessages> find_messages(const Recording& recording,
                                           const std::vector<std::uint32_t>& topics,
                                           const OtherMessages& others,
                                           std::vector<std::string>& notes) {
  std::vector<std::vector<Found>> found(topics.size());
  std::vector<std::uint32_t> all = topics;
  all.insert(all.end(), others.topics.begin(), others.topics.end());
  recording.for_each_message(all, [&](const RecordedMessage& message, std::string_view head) {
    const auto at = static_cast<std::size_t>(
        std::find(topics.begin(), topics.end(), message.topic) - topics.begin());
    if (at == topics.size()) {
      others.take(message);
      return true;
    }
    try {
      const std::int64_t stamp = parse_stamp(head, recording.topics()[message.topic].encoding);
      found[at].push_back({stamp, message});
    } catch (const Error& error) {
      fail(recording.place_of(message), ": ", error.what());
    }
    return true;
  });
  std::vector<StampedMessages> result;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const std::string place = recording.path().string() + ": " + recording.topics()[topics[i]].name;
    take_recorded_times(found[i], place, notes);
    put_in_order(found[i], recording, place, notes);
    result.push_back(without_repeats(found[i], place, notes));
  }
  return result;
}

}  // namespace vo
