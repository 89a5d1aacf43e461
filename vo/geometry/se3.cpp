#include "vo/geometry/se3.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace vo {
namespace {

/// Angle below which the closed forms cancel and their series are exact to rounding.
constexpr double kSmallAngle = 1e-4;  // rad

Eigen::Quaterniond exp_rotation(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  const double sine_over_angle =
      angle < kSmallAngle ? 0.5 - angle * angle / 48 : std::sin(angle / 2) / angle;
  const Eigen::Vector3d xyz = sine_over_angle * rotation_vector;
  return {std::cos(angle / 2), xyz.x(), xyz.y(), xyz.z()};
}

Eigen::Vector3d log_rotation(const Eigen::Quaterniond& rotation) {
  const double sign = rotation.w() < 0 ? -1 : 1;  // q and -q are the same rotation
  const Eigen::Vector3d xyz = sign * rotation.vec();
  const double w = sign * rotation.w();
  const double sine = xyz.norm();
  if (sine < kSmallAngle) {
    return (2 / w - 2 * sine * sine / (3 * w * w * w)) * xyz;
  }
  return 2 * std::atan2(sine, w) / sine * xyz;
}

/// Returns the left Jacobian V of SO(3): exp([v; w]) has the translation V * v.
Eigen::Matrix3d left_jacobian(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = skew(w);
  if (angle < kSmallAngle) {
    return Eigen::Matrix3d::Identity() + W / 2 + W * W / 6;
  }
  const double a2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / a2 * W +
         (angle - std::sin(angle)) / (a2 * angle) * W * W;
}

Eigen::Matrix3d inverse_left_jacobian(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = skew(w);
  if (angle < kSmallAngle) {
    return Eigen::Matrix3d::Identity() - W / 2 + W * W / 12;
  }
  const double half = angle / 2;
  const double c = (1 - half * std::cos(half) / std::sin(half)) / (angle * angle);
  return Eigen::Matrix3d::Identity() - W / 2 + c * W * W;
}

}  // namespace

SE3::SE3(const Eigen::Quaterniond& rotation, Eigen::Vector3d translation)
    : rotation_(rotation.normalized()), translation_(std::move(translation)) {
  assert(rotation.squaredNorm() > 0);
}

SE3 SE3::exp(const Vector6d& tangent) {
  const Eigen::Vector3d w = tangent.tail<3>();
  return {exp_rotation(w), left_jacobian(w) * tangent.head<3>()};
}

Vector6d SE3::log() const {
  const Eigen::Vector3d w = log_rotation(rotation_);
  Vector6d tangent;
  tangent << inverse_left_jacobian(w) * translation_, w;
  return tangent;
}

SE3 SE3::inverse() const {
  const Eigen::Quaterniond R_b_a = rotation_.conjugate();
  return {R_b_a, -(R_b_a * translation_)};
}

double SE3::angle() const {
  return 2 * std::atan2(rotation_.vec().norm(), std::abs(rotation_.w()));
}

SE3 operator*(const SE3& T_a_b, const SE3& T_b_c) {
  return {T_a_b.rotation() * T_b_c.rotation(), T_a_b * T_b_c.translation()};
}

Eigen::Vector3d operator*(const SE3& T_a_b, const Eigen::Vector3d& p_b) {
  return T_a_b.rotation() * p_b + T_a_b.translation();
}

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d A;
  A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return A;
}

Matrix6d adjoint(const SE3& T_a_b) {
  const Eigen::Matrix3d R = T_a_b.rotation_matrix();
  Matrix6d result = Matrix6d::Zero();
  result.topLeftCorner<3, 3>() = R;
  result.topRightCorner<3, 3>() = skew(T_a_b.translation()) * R;
  result.bottomRightCorner<3, 3>() = R;
  return result;
}

Matrix6d compounded_covariance(const SE3& T_a_b, const Matrix6d& covariance_a_b,
                               const Matrix6d& covariance_b_c) {
  const Matrix6d J = adjoint(T_a_b);
  return covariance_a_b + J * covariance_b_c * J.transpose();
}

SE3 look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  const Eigen::Vector3d right = forward.cross(up).normalized();
  Eigen::Matrix3d R_world_camera;
  R_world_camera << right, forward.cross(right), forward;
  return {Eigen::Quaterniond(R_world_camera), eye};
}

}  // namespace vo
