#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/frames/world_up.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/imu.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// The images of a sequence that are read.
enum class SequenceContent {
  colour_and_depth,
  colour_and_float_depth,  ///< depth_float.txt and its .npy files instead of depth.txt
  colour,                  ///< files and topics of depth are not touched; frames have no depth
};

/// A sequence that is open, whatever its format. The camera is x right, y down, z forward, the
/// world right-handed; readers of formats with other conventions convert them.
struct SequenceSource {
  RgbdCamera camera;
  std::vector<double> timestamps;                    ///< s, of the frames, increasing
  std::function<RgbdFrame(std::size_t index)> read;  ///< for any thread; depth is empty if absent
  Trajectory truth;                                  ///< ground truth; empty if absent
  ImuRecord imu;  ///< of the body that carries the camera; empty if absent
  SE3 T_body_camera;
  WorldUp up = WorldUp::unknown;   ///< of the world of `truth` and `imu`
  bool has_float_depth = false;    ///< depth is not rounded to units of 16 bits
  std::vector<std::string> notes;  ///< sentences on what was not as the format has it
};

}  // namespace vo
