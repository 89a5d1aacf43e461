#include "synth/path/camera_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vo/core/error.h"

namespace synth {
namespace {

vo::SE3 start_pose(const MoveOptions& options) {
  options.validate();
  return vo::look_at(options.eye, options.target, Eigen::Vector3d::UnitY());
}

/// Progress from 0 to 1 at constant speed between two ramps, on which the speed follows the cubic
/// step 3 u^2 - 2 u^3, whose slope vanishes at both ends.
class Progress {
 public:
  Progress(double ramp_s, double duration_s) : ramp_(ramp_s), duration_(duration_s) {
    vo::require(duration_s > 0 && 2 * ramp_s <= duration_s,
                "move.ramp: expected at most half of the duration, ", duration_s / 2, " s, got ",
                ramp_s);
  }

  double at(double time) const {
    return time < duration_ / 2 ? since_rest(time) : 1 - since_rest(duration_ - time);
  }

 private:
  double since_rest(double time) const {
    const double speed = 1 / (duration_ - ramp_);
    if (time >= ramp_) {
      return speed * (time - ramp_ / 2);
    }
    const double u = std::max(0.0, time / ramp_);
    return speed * ramp_ * (u * u * u - u * u * u * u / 2);
  }

  double ramp_;
  double duration_;
};

vo::SE3 turned(double angle_deg, const Eigen::Vector3d& axis) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), Eigen::Vector3d::Zero()};
}

}  // namespace

void MoveOptions::validate() const {
  vo::require(eye.allFinite() && target.allFinite() && by.allFinite() && std::isfinite(turn_deg),
              "move: expected finite numbers");
  constexpr double kMaxTurn = 1e6;  // deg, of which doubles have all digits of a turn
  vo::require(std::abs(turn_deg) <= kMaxTurn, "move.turn_deg: expected from ", -kMaxTurn, " to ",
              kMaxTurn, " deg, got ", turn_deg);
  constexpr double kLeastSine = 1e-6;  // sine of the gaze's angle to the vertical
  const Eigen::Vector3d gaze = target - eye;
  vo::require(std::hypot(gaze.x(), gaze.z()) > kLeastSine * gaze.norm(),
              "move: expected a target beside the eye, not at it or straight above or below it");
  vo::require(ramp >= 0 && std::isfinite(ramp), "move.ramp: expected 0 or above, got ", ramp);
}

CameraPath still(const MoveOptions& options) {
  return [T_world_start = start_pose(options)](double /*time*/) { return T_world_start; };
}

CameraPath dolly(const MoveOptions& options, double duration_s) {
  return [T_world_start = start_pose(options), progress = Progress(options.ramp, duration_s),
          by = options.by](double time) {
    return T_world_start * vo::SE3(Eigen::Quaterniond::Identity(), progress.at(time) * by);
  };
}

CameraPath pan(const MoveOptions& options, double duration_s) {
  return [T_world_start = start_pose(options), progress = Progress(options.ramp, duration_s),
          turn_deg = options.turn_deg](double time) {
    const vo::SE3 turn = turned(progress.at(time) * turn_deg, Eigen::Vector3d::UnitY());
    return vo::SE3(turn.rotation() * T_world_start.rotation(), T_world_start.translation());
  };
}

CameraPath roll(const MoveOptions& options, double duration_s) {
  return [T_world_start = start_pose(options), progress = Progress(options.ramp, duration_s),
          turn_deg = options.turn_deg](double time) {
    return T_world_start * turned(progress.at(time) * turn_deg, Eigen::Vector3d::UnitZ());
  };
}

}  // namespace synth
