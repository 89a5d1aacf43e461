#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/motion_files/transform_tree.h"
#include "vo/recording_files/recording.h"

namespace vo {

/// A recording and a topic in it, as users name them: `FILE:TOPIC`.
struct RecordingName {
  std::filesystem::path file;
  std::string topic;  ///< empty if there is none
};

/// Splits `FILE:TOPIC` at the first colon behind which FILE is there; a path of something that is
/// there has no topic.
RecordingName recording_name(const std::filesystem::path& path);

/// Returns the topics of tf in a recording, by their index.
std::vector<std::uint32_t> transform_topics(const Recording& recording);

/// Adds the transforms of a message of tf, those of /tf_static as fixed.
void add_transforms(const Recording& recording, const RecordedMessage& message,
                    TransformTree& tree);

/// Reads the poses of a topic: PoseStamped, PoseWithCovarianceStamped, Odometry, TransformStamped,
/// or of `/tf:PARENT.CHILD`, where one frame is in another. Without a topic, they are of the one
/// that has poses, /tf where there is no other. Stamps are those of the messages, or, where all are
/// 0, the times of recording. Appends to `notes`; throws Error that lists the topics where there is
/// none or a choice.
Trajectory read_recorded_trajectory(const Recording& recording, const std::string& topic,
                                    std::vector<std::string>& notes);

}  // namespace vo
