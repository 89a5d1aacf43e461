#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"
#include "vo/text_files/toml_file.h"

namespace vo {

/// A camera of a rig.
struct RigCamera {
  std::string name;               ///< unique in the rig; the name of the folder of its frames
  SE3 T_body_camera;              ///< the camera is x right, y down, z forward
  RgbdCamera camera;              ///< its image, lens, and the depth that is registered to it
  double time_offset = 0;         ///< s, from the body's stamp to that of this camera's frame
  std::string stereo;             ///< name of the camera to its right in a rectified pair, or empty
  std::vector<TomlValue> sensor;  ///< options of its sensor, as they are under [camera.sensor]
  std::string place;              ///< `file:line` of its table, for messages
};

/// Cameras and an IMU on one rigid body.
struct Rig {
  SE3 T_body_imu;
  std::vector<RigCamera> cameras;  ///< in the file's order, one at least
};

/// Returns the start of a message about a camera: where it stands and its name.
std::string describe(const RigCamera& camera);

/// Returns the camera that `left` names as its stereo partner, to its right. Throws Error if there
/// is none of that name, or if the two are not rectified: image and intrinsics equal, no lens
/// distortion, the same axes, frames at the same time, the partner on the positive x axis. Axes may
/// differ by 1e-7 rad, the partner may be off the axis by 1e-6 of the baseline.
const RigCamera& stereo_partner(const Rig& rig, const RigCamera& left);

/// Returns the distance, m, of the optical centres of a camera and its `stereo_partner`.
double stereo_baseline(const Rig& rig, const RigCamera& left);

}  // namespace vo
