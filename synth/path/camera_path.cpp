#include "synth/path/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "vo/core/error.h"

namespace synth {
namespace {

using Vector7d = Eigen::Matrix<double, 7, 1>;  ///< position, quaternion (x, y, z, w)

/// An interpolating cubic spline whose second derivative is continuous and vanishes at both ends.
struct NaturalSpline {
  std::vector<double> times;
  std::vector<Vector7d> values;
  std::vector<Vector7d> curvatures;  ///< second derivatives at the times

  Vector7d at(double time) const;
};

/// Evaluates the spline between two knots h apart, a and b being the shares of the knots:
///     a y0 + b y1 + ((a^3 - a) y0'' + (b^3 - b) y1'') h^2 / 6.
Vector7d NaturalSpline::at(double time) const {
  const double clamped = std::clamp(time, times.front(), times.back());
  const auto next = std::upper_bound(times.begin() + 1, times.end() - 1, clamped);
  const auto i = static_cast<std::size_t>(next - times.begin()) - 1;
  const double h = times[i + 1] - times[i];
  const double b = (clamped - times[i]) / h;
  const double a = 1 - b;
  return a * values[i] + b * values[i + 1] +
         ((a * a * a - a) * curvatures[i] + (b * b * b - b) * curvatures[i + 1]) * (h * h / 6);
}

/// Solves for second derivatives. With slopes s_i = (y_i+1 - y_i) / h_i, a continuous slope gives
///     h_i-1 y_i-1'' + 2 (h_i-1 + h_i) y_i'' + h_i y_i+1'' = 6 (s_i - s_i-1),
/// tridiagonal, solved by elimination from the first to the last knot and back.
std::vector<Vector7d> solve_curvatures(const std::vector<double>& times,
                                       const std::vector<Vector7d>& values) {
  const std::size_t count = times.size();
  std::vector<Vector7d> curvatures(count, Vector7d::Zero());
  std::vector<double> upper(count, 0.0);  // y_i'' = curvatures_i - upper_i y_i+1''
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double before = times[i] - times[i - 1];
    const double after = times[i + 1] - times[i];
    const Vector7d bend =
        6 * ((values[i + 1] - values[i]) / after - (values[i] - values[i - 1]) / before);
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    curvatures[i] = (bend - before * curvatures[i - 1]) / pivot;
  }
  for (std::size_t i = count - 1; i-- > 1;) {
    curvatures[i] -= upper[i] * curvatures[i + 1];
  }
  return curvatures;
}

NaturalSpline make_spline(const vo::Trajectory& poses) {
  NaturalSpline spline;
  for (const vo::StampedPose& pose : poses) {
    Vector7d value;
    value << pose.T_world_camera.translation(), pose.T_world_camera.rotation().coeffs();
    if (!spline.values.empty() && spline.values.back().tail<4>().dot(value.tail<4>()) < 0) {
      value.tail<4>() *= -1;
    }
    spline.times.push_back(pose.timestamp);
    spline.values.push_back(value);
  }
  spline.curvatures = solve_curvatures(spline.times, spline.values);
  return spline;
}

}  // namespace

void OrbitOptions::validate() const {
  vo::require(centre.allFinite() && std::isfinite(height) && std::isfinite(start_deg),
              "orbit: expected finite numbers");
  vo::require(radius > 0 && std::isfinite(radius), "orbit: expected radius above 0, got ", radius);
  vo::require(period > 0 && std::isfinite(period), "orbit: expected period above 0, got ", period);
}

CameraPath orbit(const OrbitOptions& options) {
  options.validate();
  return [options](double time) {
    constexpr double kPi = std::numbers::pi;
    const double angle = options.start_deg * kPi / 180 + 2 * kPi * time / options.period;
    const Eigen::Vector3d offset(options.radius * std::cos(angle), options.height,
                                 -options.radius * std::sin(angle));
    return vo::look_at(options.centre + offset, options.centre, Eigen::Vector3d::UnitY());
  };
}

CameraPath spline(const vo::Trajectory& control_poses) {
  vo::require(control_poses.size() >= 2, "spline: expected at least two control poses, got ",
              control_poses.size());
  for (std::size_t i = 1; i < control_poses.size(); ++i) {
    vo::require(control_poses[i].timestamp > control_poses[i - 1].timestamp,
                "spline: expected control poses in increasing time, got ",
                control_poses[i].timestamp, " s after ", control_poses[i - 1].timestamp, " s");
  }
  return [spline = make_spline(control_poses)](double time) {
    const Vector7d value = spline.at(time);
    return vo::SE3(Eigen::Quaterniond(Eigen::Vector4d(value.tail<4>())), value.head<3>());
  };
}

std::vector<double> sample_times(double rate_hz, double duration_s) {
  vo::require(rate_hz > 0 && duration_s >= 0 && std::isfinite(rate_hz * duration_s),
              "camera path: expected a rate above 0 Hz and a duration of 0 s or more, got ",
              rate_hz, " Hz, ", duration_s, " s");
  constexpr double kTolerance = 1e-9;  // frames, for the rounding of rate times duration
  const auto last = static_cast<std::size_t>(rate_hz * duration_s + kTolerance);
  std::vector<double> times;
  for (std::size_t i = 0; i <= last; ++i) {
    times.push_back(static_cast<double>(i) / rate_hz);
  }
  return times;
}

vo::Trajectory sample(const CameraPath& path, const std::vector<double>& times) {
  vo::Trajectory trajectory;
  for (const double time : times) {
    trajectory.push_back({time, path(time)});
  }
  return trajectory;
}

vo::Trajectory sample(const CameraPath& path, double rate_hz, double duration_s) {
  return sample(path, sample_times(rate_hz, duration_s));
}

void require_within_reach(const vo::Trajectory& trajectory) {
  constexpr double kFarthest = 1e7;  // m, where neighbouring numbers are 1 m apart
  for (const vo::StampedPose& pose : trajectory) {
    const double distance = pose.T_world_camera.translation().norm();
    vo::require(distance <= kFarthest, "path: the camera is ", distance, " m from the origin at ",
                pose.timestamp, " s, expected within ", kFarthest, " m");
  }
}

}  // namespace synth
