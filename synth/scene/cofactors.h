#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace synth {

/// The matrix that turns normals with a surface that A deforms: det(A) A^-T, singular or not.
inline Eigen::Matrix3d cofactors(const Eigen::Matrix3d& A) {
  Eigen::Matrix3d result;
  result << A.col(1).cross(A.col(2)), A.col(2).cross(A.col(0)), A.col(0).cross(A.col(1));
  return result;
}

}  // namespace synth
