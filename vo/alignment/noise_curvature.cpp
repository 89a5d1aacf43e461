#include "vo/alignment/noise_curvature.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "vo/alignment/surface_normal.h"
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

/// A Parallax is the part across the ray of a difference of gradients without noise, for a part of
/// the length |p| along the ray to the point p.
struct Parallax {
  Eigen::Vector3f across;  ///< across the ray, m
  float uncertainty;       ///< length by which `across` may be wrong, m
  float blur;              ///< share of the gradient by which it may differ along itself
};

/// Returns half the relative change of the length that a pixel sees of a surface with normal n at p
/// from the reference camera's centre to the current one. Edges of a pixel's width are blurred by
/// as much more in one image.
float blur_change(const Eigen::Vector3f& p, const Eigen::Vector3f& centre_ref,
                  const Eigen::Vector3f& n) {
  const Eigen::Vector3f from_ref = p - centre_ref;
  const float facing_ref = n.dot(from_ref);
  if (facing_ref <= 0) {
    return 1;  // the reference would see the surface from behind
  }
  const float ratio = p.squaredNorm() * facing_ref / (p.z() * from_ref.squaredNorm());
  return (1 - std::min(ratio, 1 / ratio)) / 2;
}

/// Along a camera's own ray no intensity changes, and along the surface both images change alike,
/// so that a difference without noise is along the normal n of the surface. With n . p = z at the
/// point p on it, its part along the ray is (z / |p|^2) p, and the rest (|p|^2 / z) n - p for each
/// p of that. Where the depth image does not tell, surfaces inclined by up to 72 deg are allowed
/// for.
Parallax parallax_at(const Eigen::Vector3f& p, const Eigen::Vector3f& centre_ref,
                     const std::optional<SurfaceNormal>& surface) {
  constexpr float kSteepest = 3;   // tangent of 72 deg
  constexpr float kMargin = 0.1F;  // tangent, of what bends between the pixels that are compared
  const float distance = p.norm();
  if (surface) {
    const float scale = distance * distance / p.z();
    const Eigen::Vector3f across = scale * surface->n - p;
    const float uncertainty = scale * surface->deviation.norm() + kMargin * distance;
    if (uncertainty < kSteepest * distance) {
      return {across, uncertainty, blur_change(p, centre_ref, surface->n)};
    }
  }
  return {Eigen::Vector3f::Zero(), kSteepest * distance, 0};
}

/// The parallax of each point of a block.
struct ParallaxBlock {
  BlockRow x{}, y{}, z{};  ///< `Parallax::across`, m
  BlockRow uncertainty{};  ///< m
  BlockRow blur{};         ///< share of the gradient
};

/// Finds the parallax of the points from `first` on that have a weight.
void find_parallax(const PyramidLevel& image, const PassWarp& warp, const PointTerms& terms,
                   std::size_t first, const Block& block, ParallaxBlock& found) {
  const std::size_t count = std::min(kBlock, terms.weight.size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    if (terms.weight[first + i] > 0) {
      const cv::Point pixel(cvRound(terms.u[first + i]), cvRound(terms.v[first + i]));
      const Parallax parallax =
          parallax_at({block.x[i], block.y[i], block.z[i]}, {warp.t[0], warp.t[1], warp.t[2]},
                      surface_normal(image, pixel));
      found.x[i] = parallax.across.x();
      found.y[i] = parallax.across.y();
      found.z[i] = parallax.across.z();
      found.uncertainty[i] = parallax.uncertainty;
      found.blur[i] = parallax.blur;
    }
  }
}

/// Removes from the differences what may come of the images' blur, which changes the length of a
/// gradient and not its direction.
EDVO_INLINE void remove_blur(const PassWarp& warp, const ParallaxBlock& parallax, Block& block) {
  constexpr float kSmallest = 1e-12F;  // 1/m^2, instead of division by 0
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = block.dI_dx[i];
    const float y = block.dI_dy[i];
    const float z = block.dI_dz[i];
    const float rx = warp.R[0] * x + warp.R[1] * y + warp.R[2] * z;
    const float ry = warp.R[3] * x + warp.R[4] * y + warp.R[5] * z;
    const float rz = warp.R[6] * x + warp.R[7] * y + warp.R[8] * z;
    const float along = (block.J[0][i] * rx + block.J[1][i] * ry + block.J[2][i] * rz) /
                        std::max(rx * rx + ry * ry + rz * rz, kSmallest);
    const float removed = std::max(std::min(along, parallax.blur[i]), -parallax.blur[i]);
    block.J[0][i] -= removed * rx;
    block.J[1][i] -= removed * ry;
    block.J[2][i] -= removed * rz;
  }
}

/// Removes from the differences what may come of the other direction of view: their part along the
/// current ray, which is the reference's alone, and what the surfaces make of it across the ray.
EDVO_INLINE void remove_parallax(const ParallaxBlock& parallax, Block& block) {
  constexpr float kSmallest = 1e-12F;  // m^2 or 1/m^2, instead of division by 0
  BlockRow share;                      // length of the part along the ray over that of the ray
  BlockRow length;                     // of what is left
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float x = block.x[i];
    const float y = block.y[i];
    const float z = block.z[i];
    const float distance2 = std::max(x * x + y * y + z * z, kSmallest);
    share[i] = (block.J[0][i] * x + block.J[1][i] * y + block.J[2][i] * z) / distance2;
    const float qx = block.J[0][i] - share[i] * (x + parallax.x[i]);
    const float qy = block.J[1][i] - share[i] * (y + parallax.y[i]);
    const float qz = block.J[2][i] - share[i] * (z + parallax.z[i]);
    length[i] = std::max(qx * qx + qy * qy + qz * qz, kSmallest);
    block.J[0][i] = qx;
    block.J[1][i] = qy;
    block.J[2][i] = qz;
  }
  for (float& value : length) {  // by itself: std::sqrt may set errno, and is not vectorized
    value = std::sqrt(value);
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    const float left = std::max(1 - parallax.uncertainty[i] * std::abs(share[i]) / length[i], 0.0F);
    block.J[0][i] *= left;
    block.J[1][i] *= left;
    block.J[2][i] *= left;
  }
}

EDVO_INLINE void sum_differences(const PointView& view, const PointTerms& terms, LaneSums& sums) {
  const PassWarp warp(view);
  Block block{};
  ParallaxBlock parallax;
  for (std::size_t first = 0; first < terms.weight.size(); first += kBlock) {
    load_terms(view, terms, first, block);
    place_points(warp, block);
    find_parallax(view.image, warp, terms, first, block, parallax);
    add_reference(warp, -1, block);  // half the difference: the mean less the reference's
    remove_parallax(parallax, block);
    remove_blur(warp, parallax, block);
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
