#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace vo {

/// Tangent of SE(3): [translation; rotation], metres and radians.
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Rigid transform. `SE3 T_a_b` takes coordinates from frame b to frame a: p_a = T_a_b * p_b.
/// The indices must meet: T_a_c = T_a_b * T_b_c, and T_b_a = T_a_b.inverse().
///
/// The rotation is a quaternion that is normalised after every operation: products of rotation
/// matrices whose inverse is taken as the transpose leave SO(3) exponentially fast.
class SE3 {
 public:
  SE3() = default;

  /// `rotation` need not be of unit length, but must not be zero.
  SE3(const Eigen::Quaterniond& rotation, Eigen::Vector3d translation);

  static SE3 exp(const Vector6d& tangent);

  /// Returns the tangent whose exp is this transform; its rotation part has a norm of at most pi.
  Vector6d log() const;

  SE3 inverse() const;
  const Eigen::Quaterniond& rotation() const { return rotation_; }     ///< unit, R_a_b
  const Eigen::Vector3d& translation() const { return translation_; }  ///< origin of b in a, m
  Eigen::Matrix3d rotation_matrix() const { return rotation_.toRotationMatrix(); }  ///< R_a_b
  double angle() const;  ///< rotation angle, rad, in [0, pi]

 private:
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation_ = Eigen::Vector3d::Zero();
};

SE3 operator*(const SE3& T_a_b, const SE3& T_b_c);
Eigen::Vector3d operator*(const SE3& T_a_b, const Eigen::Vector3d& p_b);

/// Returns the matrix with skew(a) * b = a x b.
Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// Returns the adjoint Ad(T), with T exp(delta) = exp(Ad(T) delta) T.
Matrix6d adjoint(const SE3& T_a_b);

/// Returns the covariance of the left increment of T_a_c = T_a_b T_b_c, given those of the left
/// increments of T_a_b and T_b_c, to first order and without correlation between the two (Barfoot &
/// Furgale, "Associating Uncertainty With Three-Dimensional Poses", 2014).
Matrix6d compounded_covariance(const SE3& T_a_b, const Matrix6d& covariance_a_b,
                               const Matrix6d& covariance_b_c);

/// Returns T_world_camera of a camera at `eye` whose optical axis runs through `target` and whose
/// image shows `up` upwards. All are in world coordinates; `up` must not be parallel to the viewing
/// direction.
SE3 look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up);

}  // namespace vo
