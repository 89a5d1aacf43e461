#include "vo/motion_files/recorded_trajectory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>

#include "vo/core/error.h"
#include "vo/motion_files/pose_collector.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/recording_files/ros_messages.h"

namespace vo {
namespace {

bool is_tf(const RecordedTopic& topic) {
  return topic.type == "tf2_msgs/TFMessage" || topic.type == "tf/tfMessage";
}

/// Returns the topics that hold poses, as `name (type)`.
std::string list_poses(const Recording& recording) {
  std::vector<std::string> names;
  for (const RecordedTopic& topic : recording.topics()) {
    if (holds_poses(topic.type)) {
      names.push_back(topic.name + " (" + topic.type + ")");
    }
  }
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text.empty() ? "none" : text;
}

/// A message's place, for errors.
struct MessagePlace {
  const Recording& recording;
  const RecordedMessage& message;

  std::string place() const { return recording.place_of(message); }
};

SE3 checked(const RosPose& pose, const MessagePlace& where) {
  const auto [x, y, z] = pose.position;
  const auto [qx, qy, qz, qw] = pose.rotation;
  const bool is_finite = std::isfinite(x + y + z) && std::isfinite(qx + qy + qz + qw);
  if (!is_finite) {
    fail(where.place(), ": expected finite numbers in its pose");
  }
  return checked_pose(where.place(), {qw, qx, qy, qz}, {x, y, z});
}

/// Returns the poses in a message.
std::vector<RosPose> poses_in(const Recording& recording, const MessagePlace& where) {
  const RecordedTopic& topic = recording.topics()[where.message.topic];
  try {
    return parse_poses(recording.read(where.message), topic.encoding, topic.type);
  } catch (const Error& error) {
    fail(where.place(), ": ", error.what());
  }
}

/// Returns the index of the topic of poses that a name, or its absence, means.
std::uint32_t choose_poses(const Recording& recording, const std::string& name) {
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> tf;
  const std::vector<RecordedTopic>& topics = recording.topics();
  for (std::uint32_t i = 0; i < topics.size(); ++i) {
    if (holds_poses(topics[i].type) && (name.empty() || topics[i].name == name)) {
      (is_tf(topics[i]) ? tf : found).push_back(i);
    }
  }
  const std::string path = recording.path().string();
  const auto other = std::find_if(topics.begin(), topics.end(), [&](const RecordedTopic& topic) {
    return !name.empty() && topic.name == name && !holds_poses(topic.type);
  });
  require(other == topics.end(), path, ": ", name, " is a ",
          other == topics.end() ? "" : other->type,
          ", expected poses, of one of: ", list_poses(recording));
  require(name.empty() || !found.empty() || !tf.empty(), path, ": has no poses of ", name,
          ", expected one of: ", list_poses(recording));
  require(!found.empty() || !tf.empty(), path, ": has no topic of poses");
  require(found.size() <= 1, path, ": has several topics of poses (", list_poses(recording),
          "); choose one as ", path, ":TOPIC");
  return found.empty() ? tf.front() : found.front();
}

Trajectory read_messages(const Recording& recording, std::uint32_t topic,
                         std::vector<std::string>& notes) {
  std::vector<std::pair<RosPose, RecordedMessage>> found;
  recording.for_each_message({topic}, [&](const RecordedMessage& message, std::string_view) {
    for (const RosPose& pose : poses_in(recording, {recording, message})) {
      found.emplace_back(pose, message);
    }
    return true;
  });
  const std::string place = recording.path().string() + ": " + recording.topics()[topic].name;
  const bool has_stamps = std::any_of(
      found.begin(), found.end(), [](const auto& each) { return each.first.header.stamp_ns != 0; });
  if (!has_stamps && !found.empty()) {
    notes.push_back(place + ": its messages have no stamps; the times of recording are taken");
  }
  PoseCollector poses(place, PoseCollector::Order::of_time);
  for (const auto& [pose, message] : found) {
    const MessagePlace where{recording, message};
    const auto stamp_ns =
        has_stamps ? pose.header.stamp_ns : static_cast<std::int64_t>(message.time_ns);
    poses.add({seconds_of(stamp_ns), checked(pose, where)}, where);
  }
  return poses.finish(notes);
}

/// Returns the frames of `PARENT.CHILD`, of which either may have dots itself.
std::pair<std::string, std::string> split_frames(const TransformTree& tree,
                                                 const std::string& frames,
                                                 const std::string& path) {
  const std::vector<std::string> known = tree.frames();
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (std::size_t dot = frames.find('.'); dot != std::string::npos;
       dot = frames.find('.', dot + 1)) {
    const std::string parent = frames.substr(0, dot);
    const std::string child = frames.substr(dot + 1);
    if (is_known(parent) && is_known(child)) {
      return {parent, child};
    }
  }
  std::string list;
  for (const std::string& name : known) {
    list += (list.empty() ? "" : ", ") + name;
  }
  fail(path, ": /tf: expected PARENT.CHILD of two of its frames (", list, "), got '", frames, "'");
}

/// Returns the frames of the one transform that moves.
std::pair<std::string, std::string> only_moving(const TransformTree& tree,
                                                const std::string& path) {
  const std::vector<std::string> moving = tree.moving();
  std::string list;
  for (const std::string& child : moving) {
    list += (list.empty() ? "" : ", ") + tree.above(child).front() + "." + child;
  }
  require(moving.size() == 1, path, ": /tf has ", moving.size(), " transforms that move (",
          list.empty() ? "none" : list, "), expected one; choose two frames as ", path,
          ":/tf:PARENT.CHILD");
  return {tree.above(moving.front()).front(), moving.front()};
}

Trajectory read_tf(const Recording& recording, const std::string& frames) {
  TransformTree tree;
  recording.for_each_message(transform_topics(recording),
                             [&](const RecordedMessage& message, std::string_view) {
                               add_transforms(recording, message, tree);
                               return true;
                             });
  tree.finish();
  const std::string path = recording.path().string();
  const auto [parent, child] =
      frames.empty() ? only_moving(tree, path) : split_frames(tree, frames, path);
  try {
    return tree.poses(parent, child);
  } catch (const Error& error) {
    fail(path, ": ", error.what());
  }
}

}  // namespace

RecordingName recording_name(const std::filesystem::path& path) {
  const std::string text = path.string();
  std::error_code ignored;
  for (std::size_t colon = text.find(':'); colon != std::string::npos && !exists(path, ignored);
       colon = text.find(':', colon + 1)) {
    if (is_regular_file(std::filesystem::path(text.substr(0, colon)), ignored)) {
      return {text.substr(0, colon), text.substr(colon + 1)};
    }
  }
  return {path, {}};
}

std::vector<std::uint32_t> transform_topics(const Recording& recording) {
  std::vector<std::uint32_t> topics;
  for (std::uint32_t i = 0; i < recording.topics().size(); ++i) {
    if (is_tf(recording.topics()[i])) {
      topics.push_back(i);
    }
  }
  return topics;
}

void add_transforms(const Recording& recording, const RecordedMessage& message,
                    TransformTree& tree) {
  const MessagePlace where{recording, message};
  const bool is_fixed = recording.topics()[message.topic].name.ends_with("tf_static");
  for (const RosPose& pose : poses_in(recording, where)) {
    const SE3 T_parent_child = checked(pose, where);
    if (is_fixed) {
      tree.add_fixed(pose.header.frame_id, pose.child_frame_id, T_parent_child);
    } else {
      tree.add(pose.header.frame_id, pose.child_frame_id,
               {seconds_of(pose.header.stamp_ns), T_parent_child});
    }
  }
}

Trajectory read_recorded_trajectory(const Recording& recording, const std::string& topic,
                                    std::vector<std::string>& notes) {
  const std::size_t colon = topic.find(':');
  const std::string frames = colon == std::string::npos ? "" : topic.substr(colon + 1);
  const std::uint32_t index = choose_poses(recording, topic.substr(0, colon));
  const RecordedTopic& chosen = recording.topics()[index];
  if (is_tf(chosen)) {
    return read_tf(recording, frames);
  }
  require(frames.empty(), recording.path().string(), ": ", chosen.name, " is a ", chosen.type,
          ", expected frames (", frames, ") of /tf alone");
  return read_messages(recording, index, notes);
}

}  // namespace vo
