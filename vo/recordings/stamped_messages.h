#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "vo/recording_files/recording.h"

namespace vo {

/// The messages of a topic in increasing order of their stamps.
struct StampedMessages {
  std::vector<double> timestamps;  ///< s
  std::vector<RecordedMessage> messages;
};

/// Messages of further topics, which are visited in the same pass over the recording.
struct OtherMessages {
  std::vector<std::uint32_t> topics;
  std::function<void(const RecordedMessage& message)> take;
};

/// Finds the messages of topics that have stamps in their headers, each topic's for itself. A
/// topic whose stamps are all 0 has the times at which it was recorded. Of several messages with
/// one stamp the first counts; stamps that go back by at most 0.5 s are sorted; `notes` say so.
/// Throws Error for stamps that go back by more, with their place.
std::vector<StampedMessages> find_messages(const Recording& recording,
                                           const std::vector<std::uint32_t>& topics,
                                           const OtherMessages& others,
                                           std::vector<std::string>& notes);

}  // namespace vo
