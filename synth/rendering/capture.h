#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "synth/rendering/infrared.h"
#include "synth/rendering/multipath.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

/// The exposure and read-out timing of a picture, whose stamp is the middle of the exposure of its
/// middle row, (height - 1) / 2.
struct Shutter {
  static constexpr double kLongest = 60;  ///< s, of exposures and of read-outs

  double exposure_time = 0;  ///< s in which each row collects light; 0 = an instant
  double readout_time = 0;   ///< s, read-out from top to bottom edge; 0 = global shutter

  /// Returns the middle of a row's exposure, s after the stamp.
  double row_time(double v, int height) const {
    return readout_time * (v - (height - 1) / 2.0) / height;
  }

  /// Returns when a share, 0 to 1, of a row's exposure has passed, s after the stamp.
  double time_in_row(double v, double share, int height) const {
    return row_time(v, height) + exposure_time * (share - 0.5);
  }

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, Shutter& shutter) {
  visit("exposure_time", shutter.exposure_time, "in which each row collects light, s; 0 = instant");
  visit("readout_time", shutter.readout_time,
        "from the image's top to its bottom edge, s: a rolling shutter; 0 = all rows at once");
}

/// T_world_camera as a function of the time after a picture's stamp, s.
using CameraMotion = std::function<vo::SE3(double time)>;

/// How the sight of a depth camera goes through solids of smooth glass (KHR_materials_volume).
enum class SolidGlass {
  straight,   ///< glass does not bend it
  refracted,  ///< by Snell's law; depths are those of the optical path, as light's time of flight
              ///< is
};

constexpr auto enum_names(SolidGlass) {
  return std::array{std::pair{SolidGlass::straight, "straight"},
                    std::pair{SolidGlass::refracted, "refracted"}};
}

/// The images that a renderer makes; those not asked for stay empty.
struct Channels {
  bool color = true;
  bool depth = true;
  bool normal = false;
  bool ids = false;        ///< instance and material ids
  bool sight = false;      ///< DepthSight; the ray tracer alone makes it
  bool multipath = false;  ///< DepthSight::multipath, with sight
  bool points = false;     ///< RenderedFrame::points; the ray tracer alone makes them
};

/// One picture to take: camera, motion, shutter, channels and the light that the camera sees.
struct Capture {
  vo::CameraModel camera;
  CameraMotion motion;
  Shutter shutter;
  Channels channels;
  std::uint64_t seed = 0;                    ///< seed of the renderer's random samples
  double scene_time = 0;                     ///< s, the stamp in the time of the scene's animations
  std::optional<InfraredBand> infrared;      ///< none for a camera that sees colours
  SolidGlass solids = SolidGlass::straight;  ///< in DepthSight
  MultipathOptions multipath;                ///< how Channels::multipath is made
};

/// Returns a capture by a camera at rest.
Capture still(const vo::CameraModel& camera, const vo::SE3& T_world_camera);

/// A camera's rotation and position at one instant.
struct CameraPose {
  Eigen::Matrix3d R_world_camera = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, world
};

/// The camera's poses while it takes a capture.
class CapturePoses {
 public:
  explicit CapturePoses(const Capture& capture);

  /// Returns the pose in the middle of the row's exposure.
  const CameraPose& of_row(int v) const {
    return rows_[rows_.size() == 1 ? 0 : static_cast<std::size_t>(v)];
  }

  /// Returns the pose at a time, s after the stamp, interpolated linearly over 256 intervals of the
  /// capture. Requires an exposure time above 0.
  CameraPose at(double time) const;

 private:
  std::vector<CameraPose> rows_;  ///< one pose per row; a single one for a global shutter
  std::vector<CameraPose> knots_;
  double first_knot_ = 0;  ///< s after the stamp, time of the first knot
  double knots_per_s_ = 0;
};

}  // namespace synth
