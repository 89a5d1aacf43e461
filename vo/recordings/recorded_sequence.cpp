#include "vo/recordings/recorded_sequence.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/error.h"
#include "vo/files/numbered_files.h"
#include "vo/geometry/associate.h"
#include "vo/motion_files/recorded_trajectory.h"
#include "vo/recording_files/ros_messages.h"
#include "vo/recordings/camera_message.h"
#include "vo/recordings/stamped_messages.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

/// A frame by its messages.
struct RecordedFrame {
  double timestamp = 0;  ///< s
  RecordedMessage image;
  std::optional<RecordedMessage> depth;
  double depth_delay = 0;  ///< s, as in RgbdFrame
};

RgbdCamera recorded_camera(const Recording& recording, const ChosenTopics& chosen) {
  const std::string& image = recording.topics()[chosen.image.index].name;
  require(chosen.camera.has_value(), recording.path().string(), ": has no CameraInfo beside ",
          image,
          "; name its topic with --camera-topic or the camera with --camera PRESET or FILE.toml");
  std::optional<RgbdCamera> camera;
  recording.for_each_message(
      {*chosen.camera}, [&](const RecordedMessage& message, std::string_view) {
        const std::string place = recording.place_of(message);
        const std::string bytes = recording.read(message);
        try {
          const RosCameraInfo info =
              parse_camera_info(bytes, recording.topics()[message.topic].encoding);
          camera = camera_of(
              info, is_rectified(image) ? Rectification::rectified : Rectification::none, place);
        } catch (const Error& error) {
          const std::string text = error.what();
          fail(text.starts_with(place) ? text : concat(place, ": ", text));
        }
        return false;
      });
  require(camera.has_value(), recording.path().string(), ": has no message of ",
          recording.topics()[*chosen.camera].name);
  return *camera;
}

/// Throws Error unless images of a topic have the camera's size.
void require_camera_size(const Recording& recording, const ImageTopic& topic,
                         const PinholeCamera& camera) {
  const cv::Size size = topic.traits.size;
  require(size == cv::Size(camera.width, camera.height), recording.path().string(), ": ",
          recording.topics()[topic.index].name, " is of ", size.width, "x", size.height,
          " px, expected the camera's ", camera.width, "x", camera.height);
}

/// Pairs images with depth of nearly the same stamp.
std::vector<RecordedFrame> frames_of(const Recording& recording, const ChosenTopics& chosen,
                                     const RecordingRequest& request, const OtherMessages& others,
                                     std::vector<std::string>& notes) {
  const bool has_depth = chosen.depth && request.content == SequenceContent::colour_and_depth;
  std::vector<std::uint32_t> topics = {chosen.image.index};
  if (has_depth) {
    topics.push_back(chosen.depth->index);
  }
  const std::vector<StampedMessages> found = find_messages(recording, topics, others, notes);
  const StampedMessages& images = found.front();
  std::vector<RecordedFrame> frames;
  if (!has_depth) {
    for (std::size_t i = 0; i < images.messages.size(); ++i) {
      frames.push_back({images.timestamps[i], images.messages[i], {}});
    }
    return frames;
  }
  for (const auto& [i, j] :
       associate(images.timestamps, found[1].timestamps, request.max_time_difference)) {
    frames.push_back({images.timestamps[i], images.messages[i], found[1].messages[j],
                      found[1].timestamps[j] - images.timestamps[i]});
  }
  require(!frames.empty(), recording.path().string(), ": no images of ",
          recording.topics()[topics[0]].name, " and ", recording.topics()[topics[1]].name,
          " lie within ", request.max_time_difference, " s of each other");
  return frames;
}

RgbdFrame read_recorded(const Recording& recording, const RecordedFrame& frame,
                        const RgbdCamera& camera) {
  const auto topic_of = [&](const RecordedMessage& message) -> const RecordedTopic& {
    return recording.topics()[message.topic];
  };
  const auto require_size_at = [&](const std::string& place, const cv::Mat& image) {
    require(image.cols == camera.pinhole.width && image.rows == camera.pinhole.height, place,
            ": is ", image.cols, "x", image.rows, " px, expected the camera's ",
            camera.pinhole.width, "x", camera.pinhole.height);
  };
  const std::string place = recording.place_of(frame.image);
  RgbdFrame result{
      frame.timestamp, decode_image(recording.read(frame.image), topic_of(frame.image), place), {}};
  require_size_at(place, result.image);
  if (frame.depth) {
    const std::string depth_place = recording.place_of(*frame.depth);
    result.depth = decode_depth(recording.read(*frame.depth), topic_of(*frame.depth),
                                camera.depth_units_per_m, depth_place);
    require_size_at(depth_place, result.depth);
    result.depth_delay = frame.depth_delay;
  }
  return result;
}

/// The truth in /tf, which a sequence can do without: of transforms that cannot be read, a note
/// says so, and there is no truth.
class TruthOfTf {
 public:
  TruthOfTf(const Recording& recording, std::vector<std::string>& notes)
      : recording_(recording), notes_(notes) {}

  OtherMessages messages() {
    return {transform_topics(recording_),
            [this](const RecordedMessage& message) { take(message); }};
  }

  /// Returns the poses of a frame below one called `world`; empty without.
  Trajectory truth(const std::string& frame) {
    constexpr const char* kWorld = "world";
    tree_.finish();
    const std::vector<std::string> above = tree_.above(frame);
    if (!is_usable_ || std::find(above.begin(), above.end(), kWorld) == above.end()) {
      return {};
    }
    Trajectory truth = tree_.poses(kWorld, frame);
    return truth.size() > 1 ? truth : Trajectory();
  }

 private:
  void take(const RecordedMessage& message) {
    if (!is_usable_) {
      return;
    }
    try {
      add_transforms(recording_, message, tree_);
    } catch (const Error& error) {
      is_usable_ = false;
      notes_.push_back(concat(error.what(), "; /tf is not taken for the truth"));
    }
  }

  const Recording& recording_;
  std::vector<std::string>& notes_;
  TransformTree tree_;
  bool is_usable_ = true;
};

}  // namespace

fs::path recording_at(const fs::path& path) {
  if (!fs::is_directory(path)) {
    return recording_format(path) ? path : fs::path();
  }
  std::string found;
  for (const std::string& name : names_in(path)) {
    if (name.ends_with(".mcap") && recording_format(path / name)) {
      require(found.empty(), path.string(), ": holds several recordings (", found, ", ", name,
              "), expected one; name the file");
      found = name;
    }
  }
  return found.empty() ? fs::path() : path / found;
}

bool records_images(const fs::path& file) {
  const Recording recording(file);
  return std::any_of(recording.topics().begin(), recording.topics().end(),
                     [](const RecordedTopic& topic) { return holds_images(topic.type); });
}

SequenceSource open_recording(const fs::path& file, const std::optional<RgbdCamera>& camera,
                              const RecordingRequest& request) {
  const auto recording = std::make_shared<const Recording>(file);
  const ChosenTopics chosen = choose_topics(*recording, request.topics);
  SequenceSource source;
  source.notes = recording->notes();
  source.camera = camera ? *camera : recorded_camera(*recording, chosen);
  require_camera_size(*recording, chosen.image, source.camera.pinhole);
  if (chosen.depth && request.content == SequenceContent::colour_and_depth) {
    require_camera_size(*recording, *chosen.depth, source.camera.pinhole);
  }
  TruthOfTf tf(*recording, source.notes);
  const OtherMessages others = request.topics.truth.empty() ? tf.messages() : OtherMessages{{}, {}};
  const auto frames = std::make_shared<const std::vector<RecordedFrame>>(
      frames_of(*recording, chosen, request, others, source.notes));
  for (const RecordedFrame& frame : *frames) {
    source.timestamps.push_back(frame.timestamp);
  }
  source.truth = request.topics.truth.empty()
                     ? tf.truth(chosen.image.traits.frame_id)
                     : read_recorded_trajectory(*recording, request.topics.truth, source.notes);
  source.read = [recording, frames, camera = source.camera](std::size_t index) {
    return read_recorded(*recording, frames->at(index), camera);
  };
  return source;
}

}  // namespace vo
