#pragma once

#include <filesystem>
#include <optional>

#include "vo/frames/sequence_frames.h"
#include "vo/recordings/sequence_topics.h"

namespace vo {

/// What of a recording a sequence is made of.
struct RecordingRequest {
  SequenceTopics topics;
  double max_time_difference = 0.02;  ///< s, between the stamps of an image and its depth
  SequenceContent content = SequenceContent::colour_and_depth;
};

/// Returns the recording that a path names: the file itself, or the one in a folder of ROS 2's;
/// empty if it is none. Throws Error where a folder holds several.
std::filesystem::path recording_at(const std::filesystem::path& path);

/// Returns whether a recording has a topic of images.
bool records_images(const std::filesystem::path& file);

/// Opens the sequence in a recording, topics chosen as `choose_topics` does. `camera` takes
/// precedence over CameraInfo, also for the units of 16-bit depth, which are mm otherwise. Frames
/// are read when they are asked for. Images and depth are paired by nearest stamp, each image once;
/// without depth, or with SequenceContent::colour, all images are frames. The truth is where /tf
/// has the image's frame below a frame called `world`, or what is asked for. Throws Error naming
/// the file, the topic and what was expected.
SequenceSource open_recording(const std::filesystem::path& file,
                              const std::optional<RgbdCamera>& camera,
                              const RecordingRequest& request = {});

}  // namespace vo
