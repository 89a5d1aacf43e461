#include "synth/truth/imu.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vo/core/error.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

enum Purpose : std::uint64_t { gyro_noise = 0x6701, gyro_walk, accel_noise, accel_walk };

/// Returns independent standard normal numbers for the three axes of a sample.
Eigen::Vector3d normals(const ImuOptions& options, Purpose purpose, std::size_t sample) {
  const vo::RandomField field(options.seed, purpose, 0);
  const int index = static_cast<int>(sample);
  return {field.normal(0, index), field.normal(1, index), field.normal(2, index)};
}

bool is_density(double value) {
  return value >= 0 && std::isfinite(value);
}

/// Returns central differences of step h. The velocities have an error of h^2 / 6 times the third
/// derivative, the acceleration one of h^2 / 12 times the fourth.
PathMotion central_differences(const CameraPath& path, double time, double step) {
  const vo::SE3 before = path(time - step);
  const vo::SE3 now = path(time);
  const vo::SE3 after = path(time + step);
  return {(after.translation() - before.translation()) / (2 * step),
          (after.translation() - 2 * now.translation() + before.translation()) / (step * step),
          (before.inverse() * after).log().tail<3>() / (2 * step)};
}

/// The samples `first` to `last` of an IMU, of which the sample 0 is at a span's begin.
struct SampleRange {
  std::int64_t first, last;
};

SampleRange samples_of(const TimeSpan& span, const TimeSpan& covered, double rate) {
  constexpr double kTolerance = 1e-9;  // samples, for the rounding of rate times duration
  const double first = std::ceil((span.begin - covered.begin) * rate - kTolerance);
  const double last = covered.end > span.end
                          ? std::ceil((covered.end - span.begin) * rate - kTolerance)
                          : std::floor((span.end - span.begin) * rate + kTolerance);
  return {-static_cast<std::int64_t>(std::max(first, 0.0)), static_cast<std::int64_t>(last)};
}

}  // namespace

void ImuOptions::validate() const {
  constexpr double kMaxRate = 1e5;  // Hz
  vo::require(noise.rate > 0 && noise.rate <= kMaxRate, "imu: expected a rate above 0 and at most ",
              kMaxRate, " Hz, got ", noise.rate);
  vo::require(std::isfinite(gravity), "imu: expected a finite gravity, got ", gravity);
  vo::require(is_density(noise.gyro_noise) && is_density(noise.gyro_bias_walk) &&
                  is_density(noise.accel_noise) && is_density(noise.accel_bias_walk),
              "imu: expected noise densities at or above 0");
}

bool ImuOptions::has_noise() const {
  return noise.gyro_noise > 0 || noise.gyro_bias_walk > 0 || noise.accel_noise > 0 ||
         noise.accel_bias_walk > 0;
}

/// Within a step of the span's ends, extrapolates linearly from one and two steps inside.
PathMotion path_motion(const CameraPath& path, const TimeSpan& span, double time) {
  const double step = std::min(1e-3, (span.end - span.begin) / 4);  // s
  if (!(step > 0)) {
    return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  }
  const double near = std::clamp(time, span.begin + step, span.end - step);
  PathMotion motion = central_differences(path, near, step);
  if (near == time) {
    return motion;
  }
  const double inwards = near > time ? step : -step;
  const PathMotion farther = central_differences(path, near + inwards, step);
  const double share = (time - near) / inwards;
  return {motion.velocity + share * (farther.velocity - motion.velocity),
          motion.acceleration + share * (farther.acceleration - motion.acceleration),
          motion.angular_velocity + share * (farther.angular_velocity - motion.angular_velocity)};
}

PathMotion path_motion(const CameraPath& path, const TimeSpan& span, const TimeSpan& around,
                       double time) {
  constexpr double kRounding = 1e-6;  // s, of times that are those of the span's ends
  if (time < span.begin - kRounding) {
    return path_motion(path, {around.begin, span.begin}, time);
  }
  if (time > span.end + kRounding) {
    return path_motion(path, {span.end, around.end}, time);
  }
  return path_motion(path, span, time);
}

vo::ImuRecord measure_imu(const CameraPath& path, const TimeSpan& span, const ImuOptions& options) {
  return measure_imu(path, span, options, span);
}

vo::ImuRecord measure_imu(const CameraPath& path, const TimeSpan& span, const ImuOptions& options,
                          const TimeSpan& covered) {
  options.validate();
  const vo::ImuNoise& noise = options.noise;
  const SampleRange range = samples_of(span, covered, noise.rate);
  const auto time_of = [&](std::int64_t sample) {
    return span.begin + static_cast<double>(sample) / noise.rate;
  };
  const TimeSpan around{time_of(range.first), time_of(range.last)};
  const double noise_scale = std::sqrt(noise.rate);
  const Eigen::Vector3d gravity(0, -options.gravity, 0);
  vo::ImuRecord record{.samples = {}, .states = {}, .noise = noise};
  vo::BodyState state;
  for (std::int64_t sample = range.first; sample <= range.last; ++sample) {
    const auto i = static_cast<std::size_t>(sample - range.first);
    state.timestamp = time_of(sample);
    state.T_world_body = path(state.timestamp);
    const PathMotion motion = path_motion(path, span, around, state.timestamp);
    state.velocity = motion.velocity;
    record.states.push_back(state);
    record.samples.push_back(
        {state.timestamp,
         motion.angular_velocity + state.gyro_bias +
             noise.gyro_noise * noise_scale * normals(options, gyro_noise, i),
         state.T_world_body.rotation().conjugate() * (motion.acceleration - gravity) +
             state.accel_bias +
             noise.accel_noise * noise_scale * normals(options, accel_noise, i)});
    state.gyro_bias += noise.gyro_bias_walk / noise_scale * normals(options, gyro_walk, i);
    state.accel_bias += noise.accel_bias_walk / noise_scale * normals(options, accel_walk, i);
  }
  return record;
}

}  // namespace synth
