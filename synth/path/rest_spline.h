#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace synth {

/// A uniform cubic B-spline of Dim values that starts and ends at rest, at its first and last
/// control point. It is twice continuously differentiable, nowhere steeper than the straight lines
/// between control points, and nowhere farther than 0.55 of their spacing from the nearest control
/// point.
template <int Dim>
class RestSpline {
 public:
  using Vector = Eigen::Matrix<double, Dim, 1>;

  /// Places one control point every `step_s` seconds.
  RestSpline(std::vector<Vector> controls, double step_s)
      : controls_(std::move(controls)), step_(step_s) {}

  double duration() const { return step_ * static_cast<double>(controls_.size() + 1); }

  /// Returns the value at a time, s, which is constant before 0 and after the duration.
  Vector at(double time) const {
    const double steps = std::clamp(time / step_, 0.0, static_cast<double>(controls_.size() + 1));
    const auto segment = std::min(static_cast<std::ptrdiff_t>(steps), count());
    const double u = steps - static_cast<double>(segment);
    const double v = 1 - u;
    return (v * v * v * control(segment - 2) +
            (3 * u * u * u - 6 * u * u + 4) * control(segment - 1) +
            (3 * v * v * v - 6 * v * v + 4) * control(segment) + u * u * u * control(segment + 1)) /
           6;
  }

 private:
  std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(controls_.size()); }

  /// Returns a control point, of which the first and the last are each repeated three times.
  const Vector& control(std::ptrdiff_t index) const {
    return controls_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, count() - 1))];
  }

  std::vector<Vector> controls_;
  double step_;
};

}  // namespace synth
