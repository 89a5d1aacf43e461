#include <exception>
#include <iostream>
#include <span>

#include "tools/bench/opencv_peer.h"
#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/sequence.h"
#include "vo/files/output.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

/// The poses of OpenCV's RgbdOdometry, frame to frame.
vo::Trajectory track(const vo::SequenceReader& sequence) {
  const auto peer = tools::opencv_peer(tools::OpencvOdometry::rgbd);
  vo::require(peer.has_value(), "it was built without libopencv-contrib-dev");
  const tools::FrameTracker tracker = peer->start(sequence.camera().pinhole);
  vo::Trajectory trajectory;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const tools::FrameSample sample = tracker(sequence.read(i));
    if (sample.T_world_camera) {
      trajectory.push_back({sequence.timestamp(i), *sample.T_world_camera});
    }
  }
  return trajectory;
}

}  // namespace

/// An outside tracker: opencv_tracker SEQUENCE CAMERA.toml OUTPUT
int main(int argc, char** argv) {
  const std::span arguments(argv, static_cast<std::size_t>(argc));
  constexpr std::size_t kArguments = 4;
  if (arguments.size() != kArguments) {
    std::cerr << "usage: opencv_tracker SEQUENCE CAMERA.toml OUTPUT\n";
    return 2;
  }
  try {
    const vo::SequenceReader sequence(arguments[1], vo::read_camera(arguments[2]));
    const vo::Trajectory trajectory = track(sequence);
    vo::write_file(arguments[3], vo::format_trajectory(trajectory), vo::ExistingOutput::replace);
    constexpr int kLost = 5;
    return trajectory.size() < sequence.size() ? kLost : 0;
  } catch (const std::exception& error) {
    std::cerr << "opencv_tracker: " << error.what() << "\n";
    return 1;
  }
}
