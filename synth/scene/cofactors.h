#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace synth {

/// Returns the cofactor matrix det(A) A^-T, also of a singular A. It maps the normals of a surface
/// to those of the surface transformed by A, up to length.
inline Eigen::Matrix3d cofactors(const Eigen::Matrix3d& A) {
  Eigen::Matrix3d result;
  result << A.col(1).cross(A.col(2)), A.col(2).cross(A.col(0)), A.col(0).cross(A.col(1));
  return result;
}

}  // namespace synth
