#include "vo/recordings/sequence_topics.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "vo/core/error.h"
#include "vo/recording_files/ros_messages.h"

namespace vo {
namespace {

constexpr const char* kCameraInfo = "sensor_msgs/CameraInfo";

std::string parent_of(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string::npos ? "" : topic.substr(0, slash);
}

/// Returns the name of the topic that image_transport published: without its suffix.
std::string published_name(const std::string& topic) {
  for (const char* suffix : {"/compressed", "/compressedDepth"}) {
    if (topic.ends_with(suffix)) {
      return parent_of(topic);
    }
  }
  return topic;
}

/// Returns the namespace of a camera, in which its images and CameraInfo are.
std::string namespace_of(const std::string& topic) {
  return parent_of(published_name(topic));
}

/// The topics of a recording, with the first image of each that has images.
class TopicSurvey {
 public:
  explicit TopicSurvey(const Recording& recording) : recording_(recording) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < recording.topics().size(); ++i) {
      if (holds_images(recording.topics()[i].type) && recording.may_have_messages(i)) {
        open.push_back(i);
      }
    }
    std::set<std::uint32_t> left(open.begin(), open.end());
    if (left.empty()) {
      return;
    }
    recording.for_each_message(open, [&](const RecordedMessage& message, std::string_view) {
      if (left.erase(message.topic) > 0) {
        images_.push_back(
            {message.topic, image_traits(recording.read(message), recording.topics()[message.topic],
                                         recording.place_of(message))});
      }
      return !left.empty();
    });
    std::sort(images_.begin(), images_.end(),
              [&](const ImageTopic& a, const ImageTopic& b) { return name_of(a) < name_of(b); });
  }

  const std::vector<ImageTopic>& images() const { return images_; }
  const std::string& name_of(const ImageTopic& topic) const { return name_of(topic.index); }
  const std::string& name_of(std::uint32_t index) const { return recording_.topics()[index].name; }

  /// Returns all topics with their types, an image's with its encoding and size, and what the file
  /// lacks, for errors.
  std::string list() const {
    std::vector<std::string> lines;
    for (std::uint32_t i = 0; i < recording_.topics().size(); ++i) {
      const RecordedTopic& topic = recording_.topics()[i];
      const auto image = std::find_if(images_.begin(), images_.end(),
                                      [&](const ImageTopic& other) { return other.index == i; });
      lines.push_back(concat(topic.name, " (", topic.type,
                             image == images_.end() ? "" : described(image->traits), ")"));
    }
    std::sort(lines.begin(), lines.end());
    std::string text = joined(lines);
    for (const std::string& note : recording_.notes()) {
      text += "; " + note;
    }
    return text;
  }

  static std::string described(const ImageTraits& traits) {
    return traits.size.empty()
               ? concat(", ", traits.encoding)
               : concat(", ", traits.encoding, ", ", traits.size.width, "x", traits.size.height);
  }

  static std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
      text += (text.empty() ? "" : ", ") + part;
    }
    return text.empty() ? "none" : text;
  }

  std::string path() const { return recording_.path().string(); }
  const Recording& recording() const { return recording_; }

 private:
  const Recording& recording_;
  std::vector<ImageTopic> images_;
};

std::string names_of_topics(const TopicSurvey& survey, const std::vector<ImageTopic>& topics) {
  std::vector<std::string> names;
  for (const ImageTopic& topic : topics) {
    names.push_back(survey.name_of(topic));
  }
  return TopicSurvey::joined(names);
}

const ImageTopic& named_image_topic(const TopicSurvey& survey, const std::string& name,
                                    const char* option) {
  const auto found =
      std::find_if(survey.images().begin(), survey.images().end(),
                   [&](const ImageTopic& topic) { return survey.name_of(topic) == name; });
  require(found != survey.images().end(), survey.path(), ": ", option, " ", name,
          ": there are no images of this topic, expected one of: ", survey.list());
  return *found;
}

std::vector<ImageTopic> topics_of_kind(const TopicSurvey& survey, ImageKind kind) {
  std::vector<ImageTopic> found;
  std::copy_if(survey.images().begin(), survey.images().end(), std::back_inserter(found),
               [&](const ImageTopic& topic) { return topic.traits.kind == kind; });
  return found;
}

/// Returns the topic of one camera that is closest to what the camera gave: as it is before
/// compressed, distorted before rectified, then in the order of names.
ImageTopic plainest(const TopicSurvey& survey, const std::vector<ImageTopic>& topics) {
  const auto rank = [&](const ImageTopic& topic) {
    const RecordedTopic& recorded = survey.recording().topics()[topic.index];
    return std::tuple(recorded.type != "sensor_msgs/Image", is_rectified(recorded.name),
                      recorded.name);
  };
  return *std::min_element(
      topics.begin(), topics.end(),
      [&](const ImageTopic& a, const ImageTopic& b) { return rank(a) < rank(b); });
}

/// Returns the topics of each camera as one.
std::vector<ImageTopic> one_of_each_camera(const TopicSurvey& survey,
                                           const std::vector<ImageTopic>& topics) {
  std::set<std::string> namespaces;
  std::vector<ImageTopic> result;
  for (const ImageTopic& topic : topics) {
    const std::string name = namespace_of(survey.name_of(topic));
    if (namespaces.insert(name).second) {
      std::vector<ImageTopic> same;
      std::copy_if(
          topics.begin(), topics.end(), std::back_inserter(same),
          [&](const ImageTopic& other) { return namespace_of(survey.name_of(other)) == name; });
      result.push_back(plainest(survey, same));
    }
  }
  return result;
}

ImageTopic choose_image(const TopicSurvey& survey, const std::string& name) {
  if (!name.empty()) {
    return named_image_topic(survey, name, "--rgb-topic");
  }
  for (const ImageKind kind : {ImageKind::colour, ImageKind::grey}) {
    const std::vector<ImageTopic> cameras =
        one_of_each_camera(survey, topics_of_kind(survey, kind));
    require(cameras.size() <= 1, survey.path(), ": has images of several cameras (",
            names_of_topics(survey, cameras), "); choose one with --rgb-topic");
    if (!cameras.empty()) {
      return cameras.front();
    }
  }
  fail(survey.path(), ": has no colour or grey images that are read; its topics: ", survey.list());
}

bool says_aligned(const std::string& name) {
  return name.find("align") != std::string::npos || name.find("registered") != std::string::npos;
}

std::optional<ImageTopic> choose_depth(const TopicSurvey& survey, const ImageTopic& image,
                                       const std::string& name) {
  if (!name.empty()) {
    return named_image_topic(survey, name, "--depth-topic");
  }
  std::vector<ImageTopic> depths =
      one_of_each_camera(survey, topics_of_kind(survey, ImageKind::depth));
  const auto narrow = [&](const auto& is_better) {
    std::vector<ImageTopic> better;
    std::copy_if(depths.begin(), depths.end(), std::back_inserter(better), is_better);
    depths = better.empty() ? depths : better;
  };
  narrow([&](const ImageTopic& topic) { return topic.traits.size == image.traits.size; });
  narrow([&](const ImageTopic& topic) { return topic.traits.frame_id == image.traits.frame_id; });
  narrow([&](const ImageTopic& topic) { return says_aligned(survey.name_of(topic)); });
  require(depths.size() <= 1, survey.path(), ": has depth of several cameras (",
          names_of_topics(survey, depths),
          "); choose the one that is registered to the image with --depth-topic");
  return depths.empty() ? std::nullopt : std::optional(depths.front());
}

std::optional<std::uint32_t> choose_camera(const TopicSurvey& survey, const ImageTopic& image,
                                           const std::string& name) {
  const std::string own = namespace_of(survey.name_of(image)) + "/camera_info";
  std::vector<std::uint32_t> all;
  const std::vector<RecordedTopic>& topics = survey.recording().topics();
  for (std::uint32_t i = 0; i < topics.size(); ++i) {
    if (topics[i].type == kCameraInfo) {
      all.push_back(i);
    }
  }
  const auto found = std::find_if(all.begin(), all.end(), [&](std::uint32_t i) {
    return topics[i].name == (name.empty() ? own : name);
  });
  require(name.empty() || found != all.end(), survey.path(), ": --camera-topic ", name,
          ": there is no CameraInfo of this topic, expected one of: ", survey.list());
  if (found != all.end()) {
    return *found;
  }
  return all.size() == 1 ? std::optional(all.front()) : std::nullopt;
}

}  // namespace

bool is_rectified(const std::string& topic) {
  const std::string name = published_name(topic);
  return name.find("rect", name.rfind('/') + 1) != std::string::npos;
}

ChosenTopics choose_topics(const Recording& recording, const SequenceTopics& names) {
  const TopicSurvey survey(recording);
  ChosenTopics chosen;
  chosen.image = choose_image(survey, names.image);
  chosen.depth = choose_depth(survey, chosen.image, names.depth);
  chosen.camera = choose_camera(survey, chosen.image, names.camera);
  return chosen;
}

}  // namespace vo
