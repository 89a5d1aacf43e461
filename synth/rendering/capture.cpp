#include "synth/rendering/capture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr int kKnotIntervals = 256;

CameraPose eye_at(const CameraMotion& motion, double time) {
  const vo::SE3 T_world_camera = motion(time);
  return {T_world_camera.rotation_matrix(), T_world_camera.translation()};
}

}  // namespace

void Shutter::validate() const {
  vo::require(exposure_time >= 0 && exposure_time <= kLongest,
              "shutter: expected exposure_time from 0 to ", kLongest, " s, got ", exposure_time);
  vo::require(readout_time >= 0 && readout_time <= kLongest,
              "shutter: expected readout_time from 0 to ", kLongest, " s, got ", readout_time);
}

Capture still(const vo::CameraModel& camera, const vo::SE3& T_world_camera) {
  return {.camera = camera, .motion = [T_world_camera](double) { return T_world_camera; }};
}

CapturePoses::CapturePoses(const Capture& capture) {
  const Shutter& shutter = capture.shutter;
  const int height = capture.camera.height();
  const int rows = shutter.readout_time > 0 ? height : 1;
  for (int v = 0; v < rows; ++v) {
    rows_.push_back(eye_at(capture.motion, rows > 1 ? shutter.row_time(v, height) : 0));
  }
  if (shutter.exposure_time > 0) {
    first_knot_ = shutter.time_in_row(0, 0, height);
    knots_per_s_ = kKnotIntervals / (-2 * first_knot_);
    for (int i = 0; i <= kKnotIntervals; ++i) {
      knots_.push_back(eye_at(capture.motion, first_knot_ + i / knots_per_s_));
    }
  }
}

CameraPose CapturePoses::at(double time) const {
  const double place = std::clamp((time - first_knot_) * knots_per_s_, 0.0, kKnotIntervals - 1e-9);
  const auto before = static_cast<std::size_t>(place);
  const double b = place - static_cast<double>(before);
  const CameraPose& from = knots_[before];
  const CameraPose& to = knots_[before + 1];
  return {(1 - b) * from.R_world_camera + b * to.R_world_camera,
          (1 - b) * from.position + b * to.position};
}

}  // namespace synth
