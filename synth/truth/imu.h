#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "synth/path/camera_path.h"
#include "vo/geometry/imu.h"

namespace synth {

/// An inertial measurement unit whose frame is the camera's. The defaults are noise-free. White
/// noise has sigma = density sqrt(rate) per sample; biases start at 0 and follow a random walk with
/// sigma = density / sqrt(rate) per sample.
struct ImuOptions {
  vo::ImuNoise noise{.rate = 200};
  double gravity = 9.81;  ///< m/s^2 along the world's -y
  std::uint64_t seed = 1;

  bool has_noise() const;  ///< whether the seed matters
  void validate() const;   ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, ImuOptions& options) {
  visit_fields(visit, options.noise);
  visit("gravity", options.gravity, "along the world's -y, m/s^2");
  visit("seed", options.seed, "of noise and biases");
}

/// The velocities and the acceleration of a path at one time.
struct PathMotion {
  Eigen::Vector3d velocity;          ///< m/s, world
  Eigen::Vector3d acceleration;      ///< m/s^2, world
  Eigen::Vector3d angular_velocity;  ///< rad/s, camera's axes
};

/// Returns a path's motion at a time, s, by central differences within the span.
PathMotion path_motion(const CameraPath& path, const TimeSpan& span, double time);

/// Returns the same at a time in a span around that of the path's own poses, before and after which
/// the path may rest: no difference is taken across the ends of `span`, where its speed may jump.
PathMotion path_motion(const CameraPath& path, const TimeSpan& span, const TimeSpan& around,
                       double time);

/// Returns samples and true states at the span's begin and every 1 / rate seconds after it.
vo::ImuRecord measure_imu(const CameraPath& path, const TimeSpan& span, const ImuOptions& options);

/// Returns the same, in the same steps from the last at or before `covered.begin` to the first at
/// or after `covered.end`, where that is outside the span; the motion is as if taken by
/// `path_motion` around it.
vo::ImuRecord measure_imu(const CameraPath& path, const TimeSpan& span, const ImuOptions& options,
                          const TimeSpan& covered);

}  // namespace synth
