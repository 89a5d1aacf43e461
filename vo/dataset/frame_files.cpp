#include "vo/dataset/frame_files.h"

#include "vo/core/error.h"
#include "vo/motion_files/pose_matrix.h"
#include "vo/motion_files/timestamp.h"

namespace vo {

std::vector<FrameFiles> paired_files(const std::vector<NumberedFile>& images,
                                     const std::vector<NumberedFile>& depths, double rate) {
  std::vector<FrameFiles> frames;
  for (const NumberedFile& image : images) {
    const double timestamp = static_cast<double>(image.number) / rate;
    require(timestamp <= kMaxTimestamp, image.path.string(), ": expected a frame within ",
            kMaxTimestamp, " s at ", rate, " Hz, got ", timestamp, " s");
    const NumberedFile* depth = find_number(depths, image.number);
    require(depth != nullptr || depths.empty(), image.path.string(),
            ": has no depth, expected a depth image of the same number as others have");
    frames.push_back({timestamp, image.path, depth == nullptr ? "" : depth->path});
  }
  return frames;
}

Trajectory poses_of_images(const std::vector<NumberedFile>& poses,
                           const std::vector<NumberedFile>& images, double rate) {
  Trajectory trajectory;
  for (const auto& [number, path] : poses) {
    if (find_number(images, number) == nullptr) {
      continue;
    }
    if (const std::optional<SE3> T_world_camera = read_pose_matrix(path)) {
      trajectory.push_back({static_cast<double>(number) / rate, *T_world_camera});
    }
  }
  return trajectory;
}

std::vector<double> stamps_of(const std::vector<FrameFiles>& frames) {
  std::vector<double> timestamps;
  for (const FrameFiles& frame : frames) {
    timestamps.push_back(frame.timestamp);
  }
  return timestamps;
}

}  // namespace vo
