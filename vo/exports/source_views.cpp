#include "vo/exports/source_views.h"

#include <memory>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/exports/undistortion.h"

namespace vo {

SequenceSource frames_with_poses(SequenceSource source, const std::string& place,
                                 std::string_view format) {
  std::vector<std::size_t> kept;
  std::vector<double> stamps;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    if (pose_at(source.truth, source.timestamps[i])) {
      kept.push_back(i);
      stamps.push_back(source.timestamps[i]);
    }
  }
  require(!kept.empty(), place, ": none of its frames has a pose, which ", format, " expects");
  if (const std::size_t without = source.timestamps.size() - kept.size(); without > 0) {
    source.notes.push_back(
        concat(without, " of ", source.timestamps.size(), " frames have no pose and are left out"));
  }
  source.timestamps = std::move(stamps);
  source.read = [read = std::move(source.read), kept = std::move(kept)](std::size_t index) {
    return read(kept.at(index));
  };
  return source;
}

SequenceSource undistorted(SequenceSource source, std::string_view format) {
  const auto undistortion = std::make_shared<const Undistortion>(source.camera.pinhole);
  const PinholeCamera& camera = undistortion->camera();
  source.notes.push_back(concat("images are undistorted, ", format, " having no such lens (",
                                to_string(source.camera.pinhole.distortion.model),
                                "): fx = ", camera.fx, ", fy = ", camera.fy, ", cx = ", camera.cx,
                                ", cy = ", camera.cy, "; depth is that of the nearest pixel"));
  if (undistortion->holes() > 0) {
    source.notes.push_back(concat(
        undistortion->holes(), " pixels of every image are outside the lens's: black, no depth"));
  }
  source.camera.pinhole = camera;
  source.read = [read = std::move(source.read), undistortion](std::size_t index) {
    return undistortion->apply(read(index));
  };
  return source;
}

SequenceSource in_world(SequenceSource source, WorldUp up) {
  if (source.up == WorldUp::unknown && !source.truth.empty()) {
    source.notes.emplace_back(
        "which axis of its world points up is not known: poses are as they were");
  }
  if (source.up == WorldUp::unknown || source.up == up) {
    return source;
  }
  const SE3 T_new_old = turn_of_world(source.up, up);
  for (StampedPose& pose : source.truth) {
    pose.T_world_camera = T_new_old * pose.T_world_camera;
  }
  for (BodyState& state : source.imu.states) {
    state.T_world_body = T_new_old * state.T_world_body;
    state.velocity = T_new_old * state.velocity;
  }
  source.up = up;
  return source;
}

}  // namespace vo
