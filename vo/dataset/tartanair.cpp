#include "vo/dataset/tartanair.h"

#include <array>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_files.h"
#include "vo/dataset/frame_images.h"
#include "vo/dataset/sequence.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

constexpr double kTartanAirRate = 10;  // Hz

RgbdCamera tartanair_camera() {
  return {{640, 480, 320, 320, 320, 240}};
}

/// Returns the motion from axes x forward, y right, z down to x right, y down, z forward.
SE3 turn_to_forward_z() {
  Eigen::Matrix3d R;
  R << 0, 1, 0,  //
      0, 0, 1,   //
      1, 0, 0;
  return {Eigen::Quaterniond(R), Eigen::Vector3d::Zero()};
}

SE3 parse_north_east_down_pose(const TextLine& line) {
  constexpr std::size_t kValues = 7;
  require(line.fields.size() == kValues, line.place(),
          ": expected 7 values (tx ty tz qx qy qz qw), got ", line.fields.size());
  std::array<double, kValues> v{};
  for (std::size_t i = 0; i < kValues; ++i) {
    v.at(i) = parse_number(line, i);
  }
  return checked_pose(line.place(), {v[6], v[3], v[4], v[5]}, {v[0], v[1], v[2]});
}

Trajectory read_north_east_down_poses(const std::filesystem::path& path,
                                      const std::vector<double>& timestamps) {
  const SE3 turn = turn_to_forward_z();
  Trajectory truth;
  TextFile(path).for_each_line([&](const TextLine& line) {
    require(truth.size() < timestamps.size(), line.place(), ": is pose ", truth.size() + 1,
            ", expected as many as there are images, ", timestamps.size());
    truth.push_back(
        {timestamps[truth.size()], turn * parse_north_east_down_pose(line) * turn.inverse()});
  });
  require(truth.size() == timestamps.size(), path.string(), ": holds ", truth.size(),
          " poses, expected as many as there are images, ", timestamps.size());
  return truth;
}

std::string format_north_east_down_poses(const SequenceSource& source) {
  const SE3 turn = turn_to_forward_z();
  std::string text;
  for (const double timestamp : source.timestamps) {
    const SE3 T = turn.inverse() * *pose_at(source.truth, timestamp) * turn;
    const Eigen::Vector3d& t = T.translation();
    const Eigen::Quaterniond& q = T.rotation();
    text += format_real(t.x());
    for (const double value : {t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
      text += " " + format_real(value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

SequenceSource open_tartanair(const std::filesystem::path& folder,
                              const std::optional<RgbdCamera>& camera) {
  const std::vector<FrameFiles> frames = paired_files(
      numbered_files(folder, "image_left", {"", "_left", ""}),
      numbered_files(folder, "depth_left", {"", "_left_depth", ".npy"}), kTartanAirRate);
  require(!frames.empty(), folder.string(), ": expected image_left/000000_left.png");
  SequenceSource source;
  source.camera = camera_of_folder(folder, camera, tartanair_camera());
  source.timestamps = stamps_of(frames);
  source.up = WorldUp::minus_y;
  source.has_float_depth = true;
  source.read = [frames, camera = source.camera](std::size_t index) {
    return read_frame(frames.at(index), camera);
  };
  if (std::filesystem::exists(folder / "pose_left.txt")) {
    source.truth = read_north_east_down_poses(folder / "pose_left.txt", source.timestamps);
  }
  return source;
}

std::vector<NamedBytes> encode_tartanair_frame(std::size_t index, const RgbdFrame& frame) {
  const std::string number = frame_number(index);
  std::vector<NamedBytes> files = {{"image_left/" + number + "_left.png", encode_png(frame.image)}};
  if (!frame.depth.empty()) {
    files.push_back({"depth_left/" + number + "_left_depth.npy", encode_npy(frame.depth)});
  }
  return files;
}

std::vector<NamedBytes> encode_tartanair_lists(const SequenceSource& source) {
  std::vector<NamedBytes> files = {{"camera.toml", format_camera(source.camera)}};
  if (!source.truth.empty()) {
    files.push_back({"pose_left.txt", format_north_east_down_poses(source)});
  }
  return files;
}

}  // namespace vo
