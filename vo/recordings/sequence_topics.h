#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vo/recording_files/recording.h"
#include "vo/recordings/image_message.h"

namespace vo {

/// Names of the topics of a sequence in a recording; empty where they are chosen by what they are.
struct SequenceTopics {
  std::string image;
  std::string depth;
  std::string camera;  ///< CameraInfo
  std::string truth;   ///< poses of the camera; `/tf:PARENT.CHILD` are those of frames in /tf

  /// Returns whether all are chosen by what they are.
  bool are_free() const {
    return image.empty() && depth.empty() && camera.empty() && truth.empty();
  }
};

/// A topic of images, by its first message.
struct ImageTopic {
  std::uint32_t index = 0;  ///< in Recording::topics
  ImageTraits traits;
};

/// The topics of a sequence, by their index in Recording::topics.
struct ChosenTopics {
  ImageTopic image;
  std::optional<ImageTopic> depth;
  std::optional<std::uint32_t> camera;
};

/// Chooses the topics of a sequence. Without names, the image is the one topic of colour, else of
/// grey, where topics of one camera (of one namespace) count as one and the image as it is comes
/// before compressed ones; depth is that of the image's size, of its frame or by its name aligned
/// to it; CameraInfo is that in the image's namespace, else of its frame. Throws Error which lists
/// the topics: where one that is named is not there, where there is none, and where several
/// qualify, of which it says what option chooses.
ChosenTopics choose_topics(const Recording& recording, const SequenceTopics& names);

/// Returns whether a topic's images are rectified, which its name says: `/camera/image_rect_color`.
bool is_rectified(const std::string& topic);

}  // namespace vo
