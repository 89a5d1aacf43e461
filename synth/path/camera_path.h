#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "vo/geometry/trajectory.h"

namespace synth {

/// A camera's motion: T_world_camera at any time in seconds.
using CameraPath = std::function<vo::SE3(double time)>;

struct TimeSpan {
  double begin = 0;  ///< s
  double end = 0;    ///< s
};

struct OrbitOptions {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m, world; the camera looks at it
  double radius = 1.0;                               ///< m
  double height = 0.0;                               ///< m above the centre
  double period = 20.0;                              ///< s per turn, counter-clockwise from above
  double start_deg = 0.0;                            ///< where it starts, deg from +x towards -z

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, OrbitOptions& options) {
  visit("centre", options.centre, "point the camera looks at, m");
  visit("radius", options.radius, "m");
  visit("height", options.height, "of the camera above the centre, m");
  visit("period", options.period, "s per turn, counter-clockwise from above");
  visit("start_deg", options.start_deg, "start, deg from +x towards -z");
}

CameraPath orbit(const OrbitOptions& options);

/// Twice continuously differentiable on SE(3), through every control pose at its time: natural
/// cubic splines of the position and of the sign-continuous quaternion, which is normalised. A
/// rigid change of the world's or the camera's frame changes the path by the same, quaternions
/// being multiplied by linear maps. Constant before the first and after the last control pose.
/// Needs at least two.
CameraPath spline(const vo::Trajectory& control_poses);

/// 0, 1 / rate, 2 / rate, ... below or at `duration`.
std::vector<double> sample_times(double rate_hz, double duration_s);

/// The path's poses at these times.
vo::Trajectory sample(const CameraPath& path, const std::vector<double>& times);

/// The path's poses at `sample_times`.
vo::Trajectory sample(const CameraPath& path, double rate_hz, double duration_s);

}  // namespace synth
