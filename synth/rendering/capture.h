#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace synth {

/// When the rows of a picture collect light. Its stamp is the middle of the exposure of its middle
/// row, (height - 1) / 2.
struct Shutter {
  double exposure_time = 0;  ///< s in which each row collects light; 0 = an instant
  double readout_time = 0;   ///< s from the image's top to its bottom edge; 0 = all rows at once

  /// The middle of a row's exposure, s after the stamp.
  double row_time(double v, int height) const {
    return readout_time * (v - (height - 1) / 2.0) / height;
  }

  /// A share, 0 to 1, of a row's exposure, s after the stamp.
  double time_in_row(double v, double share, int height) const {
    return row_time(v, height) + exposure_time * (share - 0.5);
  }

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, Shutter& shutter) {
  visit("exposure_time", shutter.exposure_time, "in which each row collects light, s; 0 = instant");
  visit("readout_time", shutter.readout_time,
        "from the image's top to its bottom edge, s: a rolling shutter; 0 = all rows at once");
}

/// T_world_camera as a function of the time after a picture's stamp, s.
using CameraMotion = std::function<vo::SE3(double time)>;

/// What of a picture is wanted. What is not stays empty.
struct Channels {
  bool color = true;
  bool depth = true;
  bool normal = false;
  bool ids = false;  ///< of instances and materials
};

/// A picture to take.
struct Capture {
  vo::PinholeCamera camera;
  CameraMotion motion;
  Shutter shutter;
  Channels channels;
  std::uint64_t seed = 0;  ///< of the samples' instants within the exposure
  double scene_time = 0;   ///< s, of the stamp, where the scene's animations play meanwhile
};

/// Of a camera at rest.
Capture still(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera);

/// Where a camera is at one instant.
struct CameraPose {
  Eigen::Matrix3d R_world_camera = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, world
};

/// Where the camera is while it takes a capture.
class CapturePoses {
 public:
  explicit CapturePoses(const Capture& capture);

  /// In the middle of the row's exposure.
  const CameraPose& of_row(int v) const {
    return rows_[rows_.size() == 1 ? 0 : static_cast<std::size_t>(v)];
  }

  /// While any row is exposed, s after the stamp: linear between 256 instants of the capture.
  CameraPose at(double time) const;

 private:
  std::vector<CameraPose> rows_;  ///< one for all where all rows are exposed at once
  std::vector<CameraPose> knots_;
  double first_knot_ = 0;  ///< s after the stamp
  double knots_per_s_ = 0;
};

}  // namespace synth
