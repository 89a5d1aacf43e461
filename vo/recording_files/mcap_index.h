#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "vo/recording_files/recording_index.h"

namespace vo {

/// Returns where the messages of an MCAP file are: by its summary, or, where that is absent or
/// damaged, by reading the file from its begin, with a note where it is cut. Throws Error naming
/// the file and the place of what is wrong.
RecordingIndex index_mcap(const RangedFile& file);

/// Visits the messages of a part, its time, place and size set, while `visit` returns true. Throws
/// Error for a message that is shorter than its head.
void for_each_mcap_message(
    const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
    const std::function<bool(std::uint32_t channel, const RecordedMessage& message)>& visit);

}  // namespace vo
