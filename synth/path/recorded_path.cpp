#include "synth/path/recorded_path.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace synth {
namespace {

vo::SE3 parse_body_camera(const std::string& text) {
  if (text.empty()) {
    return {};
  }
  const std::vector<double> v = vo::parse_reals(text, 7);
  const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
  constexpr double kUnitTolerance = 0.01;
  vo::require(std::abs(rotation.norm() - 1) < kUnitTolerance,
              "recorded.body_camera: expected a quaternion of length 1, got length ",
              rotation.norm());
  return {rotation, {v[0], v[1], v[2]}};
}

Eigen::Quaterniond scene_from_recording(const RecordedOptions& options) {
  const double turn = options.turn_deg * std::numbers::pi / 180;
  const double tilt = options.up == UpAxis::z ? -std::numbers::pi / 2 : 0;
  return Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX());
}

}  // namespace

void RecordedOptions::validate() const {
  vo::require(scale > 0 && std::isfinite(scale), "recorded.scale: expected above 0, got ", scale);
  vo::require(by.allFinite() && std::isfinite(turn_deg), "recorded: expected finite numbers");
  parse_body_camera(body_camera);
}

vo::Trajectory placed(const vo::Trajectory& recording, const RecordedOptions& options) {
  options.validate();
  const vo::SE3 T_body_camera = parse_body_camera(options.body_camera);
  const Eigen::Quaterniond R_scene_recording = scene_from_recording(options);
  vo::Trajectory result;
  for (const vo::StampedPose& pose : recording) {
    const vo::SE3 T_recording_camera = pose.T_world_camera * T_body_camera;
    const Eigen::Vector3d position = options.scale * T_recording_camera.translation();
    result.push_back({pose.timestamp, vo::SE3(R_scene_recording * T_recording_camera.rotation(),
                                              options.by + R_scene_recording * position)});
  }
  return result;
}

}  // namespace synth
