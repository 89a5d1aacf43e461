#include "vo/bootstrap/homography.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "vo/bootstrap/pair_terms.h"
#include "vo/core/median.h"
#include "vo/core/normal_equations.h"

namespace vo {
namespace {

/// Unknowns of a homography, whose scale is free: all entries of a relative change but the last.
constexpr int kUnknowns = 8;

using HomographyEquations = NormalEquations<kUnknowns>;

Eigen::Vector2d transfer_residual(const RayPair& pair, const Eigen::Matrix3d& H) {
  return Eigen::Vector3d(H * pair.first.homogeneous()).hnormalized() - pair.second;
}

/// Returns the derivative of the residual by the entries of A, row by row, where H becomes
/// (I + A) H.
Eigen::Matrix<double, 2, kUnknowns> residual_by_change(const RayPair& pair,
                                                       const Eigen::Matrix3d& H) {
  const Eigen::Vector3d p = H * pair.first.homogeneous();
  const Eigen::RowVector3d by_row = p.transpose() / p.z();
  const Eigen::Vector2d seen = p.hnormalized();
  Eigen::Matrix<double, 2, kUnknowns> J = Eigen::Matrix<double, 2, kUnknowns>::Zero();
  J.block<1, 3>(0, 0) = by_row;
  J.block<1, 3>(1, 3) = by_row;
  J.rightCols<2>() = -seen * by_row.head<2>();
  return J;
}

Eigen::Matrix3d changed(const Eigen::Matrix3d& H, const HomographyEquations::Vector& change) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  A.row(0) = change.segment<3>(0);
  A.row(1) = change.segment<3>(3);
  A.row(2).head<2>() = change.tail<2>();
  return H + A * H;
}

std::vector<double> transfer_distances(const std::vector<RayPair>& pairs,
                                       const Eigen::Matrix3d& H) {
  std::vector<double> distances;
  for (const RayPair& pair : pairs) {
    distances.push_back(transfer_residual(pair, H).norm());
  }
  return distances;
}

/// Returns a residual's share of Torr's criterion: its square in standard deviations, at most what
/// calling the pair an outlier costs.
double criterion_share(double distance, double sigma, double free_dimensions) {
  constexpr double kOutlier = 2;
  return std::min(distance * distance / (sigma * sigma), kOutlier * free_dimensions);
}

/// A plane through the pairs and the motion between the two views of it.
struct PlaneMotion {
  Eigen::Matrix3d R;
  Eigen::Vector3d translation;  ///< in units of the plane's distance
  Eigen::Vector3d normal;       ///< of unit length
};

/// Returns the four motions and planes that a homography of middle singular value 1 comes from.
std::vector<PlaneMotion> decompositions(const Eigen::Matrix3d& H) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(H, Eigen::ComputeFullV);
  const Eigen::Vector3d squares = svd.singularValues().cwiseAbs2();
  const Eigen::Matrix3d V = svd.matrixV() * (svd.matrixV().determinant() < 0 ? -1 : 1);
  const double near = std::sqrt(std::max(1 - squares[2], 0.0));
  const double far = std::sqrt(std::max(squares[0] - 1, 0.0));
  std::vector<PlaneMotion> found;
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector3d kept =
        (near * V.col(0) + sign * far * V.col(2)) / std::sqrt(squares[0] - squares[2]);
    Eigen::Matrix3d U;
    Eigen::Matrix3d W;
    U << V.col(1), kept, V.col(1).cross(kept);
    const Eigen::Vector3d a = H * V.col(1);
    const Eigen::Vector3d b = H * kept;
    W << a, b, a.cross(b);
    const Eigen::Matrix3d R = W * U.transpose();
    const Eigen::Vector3d normal = U.col(2);
    const Eigen::Vector3d translation = (H - R) * normal;
    found.push_back({R, translation, normal});
    found.push_back({R, -translation, -normal});
  }
  return found;
}

/// Returns the share of pairs that lie on the plane before both cameras.
double in_front(const std::vector<RayPair>& pairs, const PlaneMotion& motion) {
  const Eigen::Matrix3d H = motion.R + motion.translation * motion.normal.transpose();
  const auto count = std::count_if(pairs.begin(), pairs.end(), [&](const RayPair& pair) {
    const Eigen::Vector3d ray = pair.first.homogeneous();
    return motion.normal.dot(ray) > 0 && (H * ray).z() > 0;
  });
  return static_cast<double>(count) / static_cast<double>(pairs.size());
}

/// Returns the homography of middle singular value 1, and of the sign that keeps points in front.
Eigen::Matrix3d normalized(const Eigen::Matrix3d& H) {
  const double middle = Eigen::JacobiSVD<Eigen::Matrix3d>(H).singularValues()[1];
  return H / (H.determinant() < 0 ? -middle : middle);
}

}  // namespace

Eigen::Matrix3d fit_homography(const std::vector<RayPair>& pairs, const SE3& T_rotation) {
  constexpr int kIterations = 20;
  Eigen::Matrix3d H = T_rotation.rotation_matrix();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const double scale = std::max(1.5 * upper_median(transfer_distances(pairs, H)), 1e-5);
    HomographyEquations system{1e-12 * HomographyEquations::Matrix::Identity()};
    for (const RayPair& pair : pairs) {
      const Eigen::Vector2d r = transfer_residual(pair, H);
      system.add_residuals(residual_by_change(pair, H), r, cauchy_weight(r.squaredNorm(), scale));
    }
    H = changed(H, system.step());
  }
  return H;
}

bool is_planar(const std::vector<RayPair>& pairs, const Eigen::Matrix3d& H, const TwoViewFit& free,
               double robust_scale) {
  constexpr double kLeastSigma = 0.1;  // of the robust scale
  const auto count = static_cast<double>(pairs.size());
  std::vector<double> free_distances;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairTerms terms = terms_of(pairs[i], free.T_second_first, free.inverse_depth[i]);
    free_distances.push_back(terms.in_front ? terms.r.norm() : 1);
  }
  const double sigma = std::max(robust_sigma(free_distances), kLeastSigma * robust_scale);
  // A plane leaves two dimensions of a pair unexplained, free depths leave one.
  const std::vector<double> plane_distances = transfer_distances(pairs, H);
  double plane = kUnknowns * std::log(4 * count);
  double depths = count * std::log(4.0) + 5 * std::log(4 * count);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    plane += criterion_share(plane_distances[i], sigma, 2);
    depths += criterion_share(free_distances[i], sigma, 1);
  }
  return plane < depths;
}

std::vector<SE3> motions_of_plane(const std::vector<RayPair>& pairs, const Eigen::Matrix3d& H,
                                  double min_in_front) {
  std::vector<SE3> motions;
  for (const PlaneMotion& motion : decompositions(normalized(H))) {
    const double length = motion.translation.norm();
    if (length > 1e-9 && in_front(pairs, motion) >= min_in_front) {
      motions.emplace_back(Eigen::Quaterniond(motion.R), motion.translation / length);
    }
  }
  return motions;
}

}  // namespace vo
