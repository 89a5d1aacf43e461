#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "vo/recording_files/recording_index.h"

namespace vo {

/// What a ROS 1 bag begins with, version 2.0.
inline constexpr std::string_view kBagMagic = "#ROSBAG V2.0\n";

/// Returns where the messages of a bag are: by its index, or, where it was not closed or is cut, by
/// reading it from its begin, with a note. Throws Error naming the file and the place of what is
/// wrong.
RecordingIndex index_bag(const RangedFile& file);

/// Visits the messages of a part, its time, place and size set, while `visit` returns true. Throws
/// Error for records that are damaged.
void for_each_bag_message(
    const RecordBytes& bytes, std::uint64_t begin, std::uint64_t end,
    const std::function<bool(std::uint32_t channel, const RecordedMessage& message)>& visit);

}  // namespace vo
