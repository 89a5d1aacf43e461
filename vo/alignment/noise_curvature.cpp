#include "vo/alignment/noise_curvature.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "vo/residuals/lane_sums.h"

namespace vo {
namespace {

using detail::add_reference;
using detail::Block;
using detail::BlockRow;
using detail::complete_rotations;
using detail::kBlock;
using detail::LaneSums;
using detail::load_points;
using detail::load_row;
using detail::PassWarp;

/// Loads the points from `first` on, with their mean Jacobians and weights. Where there are fewer
/// than a block has, the others have weight 0.
EDVO_INLINE void load_terms(const PointView& view, const PointTerms& terms, std::size_t first,
                            Block& block) {
  const std::size_t count = std::min(kBlock, terms.weight.size() - first);
  const EdgePointLevel& points = view.points;
  load_points(points, first, count, block);
  load_row(points.dI_dx, first, count, block.dI_dx);
  load_row(points.dI_dy, first, count, block.dI_dy);
  load_row(points.dI_dz, first, count, block.dI_dz);
  for (std::size_t p = 0; p < kPassParameters; ++p) {
    load_row(terms.J[p], first, count, block.J[p]);
  }
  block.weight.fill(0);
  load_row(terms.weight, first, count, block.weight);
}

/// Places the points in the current camera's frame, m.
EDVO_INLINE void place_points(const PassWarp& warp, Block& block) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = block.x_ref[i];
    const float y = block.y_ref[i];
    const float z = block.z_ref[i];
    block.x[i] = warp.R[0] * x + warp.R[1] * y + warp.R[2] * z + warp.t[0];
    block.y[i] = warp.R[3] * x + warp.R[4] * y + warp.R[5] * z + warp.t[1];
    block.z[i] = warp.R[6] * x + warp.R[7] * y + warp.R[8] * z + warp.t[2];
  }
}

/// Removes from the differences what may come of the other direction of view. Along a camera's own
/// ray no intensity changes, so that what the difference has along the current ray is the
/// reference's alone. The gradient of a surface inclined by an angle a to the view changes across
/// the ray by at most tan(a) times that.
EDVO_INLINE void remove_parallax(Block& block) {
  constexpr float kSteepest = 3;       // tan(a) of the surfaces that are allowed for, 72 deg
  constexpr float kSmallest = 1e-12F;  // m^2 or 1/m^2, instead of division by 0
  BlockRow share;                      // length of the part along the ray over that of the ray
  BlockRow ratio;                      // length of the ray over that of the part across it
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = block.x[i];
    const float y = block.y[i];
    const float z = block.z[i];
    const float distance2 = std::max(x * x + y * y + z * z, kSmallest);
    share[i] = (block.J[0][i] * x + block.J[1][i] * y + block.J[2][i] * z) / distance2;
    const float qx = block.J[0][i] - share[i] * x;
    const float qy = block.J[1][i] - share[i] * y;
    const float qz = block.J[2][i] - share[i] * z;
    ratio[i] = distance2 / std::max(qx * qx + qy * qy + qz * qz, kSmallest);
    block.J[0][i] = qx;
    block.J[1][i] = qy;
    block.J[2][i] = qz;
  }
  for (float& value : ratio) {  // by itself: std::sqrt may set errno, and is not vectorized
    value = std::sqrt(value);
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float left = std::max(1 - kSteepest * std::abs(share[i]) * ratio[i], 0.0F);
    block.J[0][i] *= left;
    block.J[1][i] *= left;
    block.J[2][i] *= left;
  }
}

EDVO_INLINE void sum_differences(const PointView& view, const PointTerms& terms, LaneSums& sums) {
  const PassWarp warp(view);
  Block block{};
  for (std::size_t first = 0; first < terms.weight.size(); first += kBlock) {
    load_terms(view, terms, first, block);
    place_points(warp, block);
    add_reference(warp, -1, block);  // half the difference: the mean less the reference's
    remove_parallax(block);
    complete_rotations(block);
    sums.add(kPassParameters, block);
  }
}

void sum_differences_baseline(const PointView& view, const PointTerms& terms, LaneSums& sums) {
  sum_differences(view, terms, sums);
}

EDVO_TARGET_AVX2 void sum_differences_avx2(const PointView& view, const PointTerms& terms,
                                           LaneSums& sums) {
  sum_differences(view, terms, sums);
}

EDVO_TARGET_AVX512 void sum_differences_avx512(const PointView& view, const PointTerms& terms,
                                               LaneSums& sums) {
  sum_differences(view, terms, sums);
}

}  // namespace

PointEquations noise_equations(const PointView& view, const PointTerms& terms) {
  const auto sum = version_for(available_instruction_set(), sum_differences_baseline,
                               sum_differences_avx2, sum_differences_avx512);
  LaneSums sums;
  sum(view, terms, sums);
  PointEquations equations;
  sums.flush_into(equations);
  return equations;
}

NoiseFreeCurvature::NoiseFreeCurvature(const Matrix6d& H, const Matrix6d& noise) {
  const Eigen::LLT<Matrix6d> cholesky(H);
  Matrix6d whitening;
  for (Eigen::Index k = 0; k < whitening.cols(); ++k) {
    whitening.col(k) = cholesky.matrixL().solve(Vector6d::Unit(k));
  }
  const Matrix6d scaled = whitening * noise * whitening.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(scaled);
  shares_ = solver.eigenvalues().cwiseMin(1);
  directions_ = whitening.transpose() * solver.eigenvectors();
}

Matrix6d NoiseFreeCurvature::inverse() const {
  constexpr double kLeast = 0.1;
  const Vector6d left = (1 - shares_.array()).max(kLeast);
  return directions_ * left.cwiseInverse().asDiagonal() * directions_.transpose();
}

}  // namespace vo
