#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "vo/geometry/trajectory.h"

namespace synth {

/// A camera's motion: T_world_camera at any time in seconds.
using CameraPath = std::function<vo::SE3(double time)>;

struct TimeSpan {
  double begin = 0;  ///< s, start of the span
  double end = 0;    ///< s, end of the span
};

struct OrbitOptions {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m, world; point the camera looks at
  double radius = 1.0;                               ///< m, horizontal distance from the centre
  double height = 0.0;                               ///< m above the centre
  double period = 20.0;                              ///< s per turn, counter-clockwise from above
  double start_deg = 0.0;                            ///< deg, start angle from +x towards -z

  void validate() const;  ///< throws vo::Error if out of range
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

/// Returns a path on SE(3) through every control pose at its time: natural cubic splines of the
/// position and of the sign-continuous quaternion, which is normalised. The path is twice
/// continuously differentiable between the first and the last pose and constant before and after.
/// Rigid changes of the world's frame and rotations of the camera's frame carry over to the path,
/// since they act linearly on quaternions. Throws vo::Error for fewer than two poses.
CameraPath spline(const vo::Trajectory& control_poses);

/// Returns the times 0, 1 / rate, 2 / rate, ... below or at the duration, s.
std::vector<double> sample_times(double rate_hz, double duration_s);

/// Returns the path's poses at these times, s.
vo::Trajectory sample(const CameraPath& path, const std::vector<double>& times);

/// Returns the path's poses at `sample_times`.
vo::Trajectory sample(const CameraPath& path, double rate_hz, double duration_s);

/// Throws vo::Error if a pose is farther than 1e7 m from the world's origin, where rays in single
/// precision say nothing any more.
void require_within_reach(const vo::Trajectory& trajectory);

}  // namespace synth
