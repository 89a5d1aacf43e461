#pragma once

#include <span>

#include <Eigen/Core>

namespace vo {

/// The map p -> scale * rotation * p + translation.
struct Similarity {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double scale = 1;
};

Eigen::Vector3d operator*(const Similarity& similarity, const Eigen::Vector3d& point);

/// Returns the rigid motion with the least sum of squared distances between its images of the
/// source points and the target points (S. Umeyama, "Least-Squares Estimation of Transformation
/// Parameters Between Two Point Patterns", PAMI 1991). Both spans have equal sizes of at least one.
/// The rotation is proper even where the points leave it undetermined, because they coincide or lie
/// on a line.
Similarity fit_rigid(std::span<const Eigen::Vector3d> source,
                     std::span<const Eigen::Vector3d> target);

/// Returns the similarity of least squares: as `fit_rigid` with the scale fitted too, which stays 1
/// when all source points coincide, and when all target points do: a scale of 0 would hide any
/// error.
Similarity fit_similarity(std::span<const Eigen::Vector3d> source,
                          std::span<const Eigen::Vector3d> target);

}  // namespace vo
