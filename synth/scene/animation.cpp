#include "synth/scene/animation.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace synth {
namespace {

enum class Part { in_tangent, value, out_tangent };

/// Returns the numbers of a key's value or, in a cubic spline, of one of its tangents.
Eigen::Map<const Eigen::VectorXf> key_part(const AnimationCurve& curve, std::size_t key,
                                           Part part) {
  const bool has_tangents = curve.interpolation == Interpolation::cubic_spline;
  const std::size_t row = has_tangents ? 3 * key + static_cast<std::size_t>(part) : key;
  return {curve.values.data() + row * static_cast<std::size_t>(curve.width), curve.width};
}

Eigen::VectorXd key_value(const AnimationCurve& curve, std::size_t key) {
  return key_part(curve, key, Part::value).cast<double>();
}

Eigen::VectorXd slerp(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double share) {
  const auto quaternion = [](const Eigen::VectorXd& xyzw) {
    return Eigen::Quaterniond(Eigen::Vector4d(xyzw)).normalized();
  };
  return quaternion(from).slerp(share, quaternion(to)).coeffs();
}

/// Evaluates the cubic Hermite spline of glTF 2.0, appendix C.5; `step` is the interval, s.
Eigen::VectorXd spline(const AnimationCurve& curve, std::size_t key, double share, double step) {
  const double t = share;
  const double t2 = t * t;
  const double t3 = t2 * t;
  const auto part = [&](std::size_t index, Part which) -> Eigen::VectorXd {
    return key_part(curve, index, which).cast<double>();
  };
  return (2 * t3 - 3 * t2 + 1) * part(key, Part::value) +
         step * (t3 - 2 * t2 + t) * part(key, Part::out_tangent) +
         (3 * t2 - 2 * t3) * part(key + 1, Part::value) +
         step * (t3 - t2) * part(key + 1, Part::in_tangent);
}

Eigen::VectorXd interpolate(const AnimationCurve& curve, std::size_t key, double time) {
  const double begin = curve.times[key];
  const double step = curve.times[key + 1] - begin;
  const double share = (time - begin) / step;
  switch (curve.interpolation) {
    case Interpolation::step:
      return key_value(curve, key);
    case Interpolation::cubic_spline:
      return spline(curve, key, share, step);
    default:
      break;
  }
  const Eigen::VectorXd from = key_value(curve, key);
  const Eigen::VectorXd to = key_value(curve, key + 1);
  return curve.holds_quaternions ? slerp(from, to, share)
                                 : Eigen::VectorXd((1 - share) * from + share * to);
}

Eigen::VectorXd vector_at(const AnimationCurve& curve, double time) {
  const std::size_t last = curve.times.size() - 1;
  if (!(time > curve.times.front())) {
    return key_value(curve, 0);
  }
  if (time >= curve.times[last]) {
    return key_value(curve, last);
  }
  const auto next = std::upper_bound(curve.times.begin(), curve.times.end(), time);
  return interpolate(curve, static_cast<std::size_t>(next - curve.times.begin()) - 1, time);
}

}  // namespace

std::vector<double> value_at(const AnimationCurve& curve, double time) {
  Eigen::VectorXd value = vector_at(curve, time);
  if (curve.holds_quaternions) {
    value.stableNormalize();
  }
  return {value.begin(), value.end()};
}

bool is_constant(const AnimationCurve& curve) {
  const Eigen::VectorXd first = key_value(curve, 0);
  const bool has_tangents = curve.interpolation == Interpolation::cubic_spline;
  for (std::size_t key = 0; key < curve.times.size(); ++key) {
    const bool is_flat = !has_tangents || (key_part(curve, key, Part::in_tangent).isZero(0) &&
                                           key_part(curve, key, Part::out_tangent).isZero(0));
    if (!is_flat || key_value(curve, key) != first) {
      return false;
    }
  }
  return true;
}

}  // namespace synth
