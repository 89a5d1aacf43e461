#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"
#include "vo/text_files/toml_file.h"

namespace vo {

/// The light that a camera sees: its colours, or near infrared as one grey value.
enum class Spectrum { visible, infrared };

constexpr auto enum_names(Spectrum) {
  return std::array{std::pair{Spectrum::visible, "visible"},
                    std::pair{Spectrum::infrared, "infrared"}};
}

/// A camera of a rig.
struct RigCamera {
  std::string name;        ///< unique in the rig; the name of the folder of its frames
  SE3 T_body_camera;       ///< the camera is x right, y down, z forward
  RgbdCameraModel camera;  ///< its image, lens, and the depth that is registered to it
  double time_offset = 0;  ///< s, from the body's stamp to that of this camera's frame
  std::string stereo;      ///< name of the camera to its right in a rectified pair, or empty
  Spectrum spectrum = Spectrum::visible;  ///< infrared cameras alone see what projectors light
  double scene_light = 1;         ///< share of the scene's light that an infrared camera sees
  std::vector<TomlValue> sensor;  ///< options of its sensor, as they are under [camera.sensor]
  std::string place;              ///< `file:line` of its table, for messages
};

/// A pattern of round dots, spread at random and evenly over its rectangle.
struct RandomDots {
  int number = 5000;
  double diameter_deg = 0.3;  ///< on the optical axis, where a dot is half as bright as its centre
  std::uint64_t seed = 0;
};

/// The value of RigProjector::pattern that stands for RandomDots.
inline constexpr const char* kRandomDots = "random_dots";

/// A projector of a pattern, infrared, which the body carries.
struct RigProjector {
  std::string name;                                   ///< unique among the projectors
  SE3 T_body_projector;                               ///< x right, y down, z forward, as a camera
  Eigen::Vector2d fov_deg = Eigen::Vector2d::Zero();  ///< of the pattern, horizontal and vertical
  double power = 1;  ///< radiant intensity at the pattern's white, lamps' unit (cd), 0 to 1e9
  std::string pattern = kRandomDots;  ///< or a PNG file's path, relative to the rig's file
  RandomDots dots;                    ///< of the pattern kRandomDots
  std::filesystem::path folder;       ///< of the rig's file
  std::string place;                  ///< `file:line` of its table, for messages

  bool has_file() const { return pattern != kRandomDots; }
  std::filesystem::path file() const { return folder / pattern; }  ///< requires has_file()
};

/// Cameras, an IMU and projectors on one rigid body.
struct Rig {
  SE3 T_body_imu;
  std::vector<RigCamera> cameras;        ///< in the file's order, one at least
  std::vector<RigProjector> projectors;  ///< likewise, or none
};

/// Returns whether a name can be that of a file or folder: letters, digits, '-' and '_', at least
/// one.
bool is_plain_name(const std::string& name);

/// Returns the start of a message about a camera: where it stands and its name.
std::string describe(const RigCamera& camera);

/// Likewise of a projector.
std::string describe(const RigProjector& projector);

/// Returns whether a camera of the rig sees infrared light.
bool has_infrared_camera(const Rig& rig);

/// Returns the camera that `left` names as its stereo partner, to its right. Throws Error if there
/// is none of that name, or if the two are not rectified: pinholes, image and intrinsics equal, no
/// lens distortion, the same axes, frames at the same time, the partner on the positive x axis.
/// Axes may differ by 1e-7 rad, the partner may be off the axis by 1e-6 of the baseline.
const RigCamera& stereo_partner(const Rig& rig, const RigCamera& left);

/// Returns the distance, m, of the optical centres of a camera and its `stereo_partner`.
double stereo_baseline(const Rig& rig, const RigCamera& left);

}  // namespace vo
