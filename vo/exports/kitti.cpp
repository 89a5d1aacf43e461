#include "vo/exports/kitti.h"

#include <string>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/trajectory_file.h"

namespace vo {
namespace {

const std::string kSequence = "sequences/00/";

/// Returns the projection matrix of each of KITTI's four cameras.
std::string format_kitti_calibration(const PinholeCamera& camera) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    text += concat("P", i, ": ", format_real(camera.fx), " 0 ", format_real(camera.cx), " 0 0 ",
                   format_real(camera.fy), " ", format_real(camera.cy), " 0 0 0 1 0\n");
  }
  return text;
}

}  // namespace

std::vector<NamedBytes> KittiOdometry::encode_frame(std::size_t index,
                                                    const RgbdFrame& frame) const {
  const char* folder = frame.image.channels() == 1 ? "image_0" : "image_2";
  return {{frame_file(kSequence + folder, index, "png"), encode_png(frame.image)}};
}

std::vector<NamedBytes> KittiOdometry::encode_lists() const {
  Trajectory poses;
  for (const double timestamp : source_.timestamps) {
    poses.push_back({timestamp, pose_at(source_.truth, timestamp).value_or(SE3())});
  }
  std::vector<NamedBytes> files = {
      {kSequence + "calib.txt", format_kitti_calibration(source_.camera.pinhole)},
      {kSequence + "times.txt", format_kitti_times(poses)}};
  if (!source_.truth.empty()) {
    const SE3 T_first_world = poses.front().T_world_camera.inverse();
    for (StampedPose& pose : poses) {
      pose.T_world_camera = T_first_world * pose.T_world_camera;
    }
    files.push_back({"poses/00.txt", format_kitti_poses(poses)});
  }
  return files;
}

}  // namespace vo
