#pragma once

#include <cmath>

#include <Eigen/Core>

#include "vo/bootstrap/two_view.h"
#include "vo/geometry/se3.h"

namespace vo {

/// The residual of one pair and its derivatives; the point is P = R ray + d t, up to its scale.
struct PairTerms {
  Eigen::Vector2d r{0, 0};
  Eigen::Matrix<double, 2, 6> by_pose;  ///< left increment [translation; rotation]
  Eigen::Vector2d by_depth;
  bool in_front = false;
};

inline PairTerms terms_of(const RayPair& pair, const SE3& T, double d) {
  PairTerms terms;
  const Eigen::Vector3d P = T.rotation() * pair.first.homogeneous() + d * T.translation();
  terms.in_front = P.z() > 1e-3;
  if (!terms.in_front) {
    return terms;
  }
  Eigen::Matrix<double, 2, 3> by_point;
  by_point << 1, 0, -P.x() / P.z(), 0, 1, -P.y() / P.z();
  by_point /= P.z();
  terms.r = P.hnormalized() - pair.second;
  terms.by_pose << d * by_point, -by_point * skew(P);
  terms.by_depth = by_point * T.translation();
  return terms;
}

/// Returns Cauchy's weight of a squared residual.
inline double cauchy_weight(double square, double scale) {
  return 1 / (1 + square / (scale * scale));
}

/// Returns Cauchy's loss of a squared residual.
inline double cauchy_loss(double square, double scale) {
  return scale * scale * std::log1p(square / (scale * scale));
}

/// Returns a pair's loss; a point behind the camera counts as a residual of four scales.
inline double pair_loss(const RayPair& pair, const SE3& T, double d, double scale) {
  constexpr double kBehind = 4;
  const PairTerms terms = terms_of(pair, T, d);
  return cauchy_loss(
      terms.in_front && d > 0 ? terms.r.squaredNorm() : kBehind * kBehind * scale * scale, scale);
}

}  // namespace vo
