#include "vo/residuals/rolling_shutter_moments.h"

#include <algorithm>

#include "vo/core/instruction_set.h"
#include "vo/residuals/lane_sums.h"

namespace vo {
namespace {

using detail::add_products;
using detail::BlockRow;
using detail::kBlock;
using detail::kLanes;
using detail::Lanes;
using detail::load_row;
using detail::total;

/// The distances of points past the middle row and the middle column, as shares of the image's
/// size, in the order of ReadoutAxis.
using LinePlaces = std::array<BlockRow, 2>;

/// The terms of 64 points of a view. Where there are fewer, the others have weight 0.
struct alignas(64) MomentBlock {
  std::array<BlockRow, kPassParameters> J;
  BlockRow weight, residual;  // residual in intensity
  LinePlaces points, image;   // at the points' own pixels, and where they are looked up

  EDVO_INLINE void load(const PointView& view, const PointTerms& terms, std::size_t first) {
    const std::size_t count = std::min(kBlock, terms.weight.size() - first);
    for (std::size_t p = 0; p < kPassParameters; ++p) {
      load_row(terms.J[p], first, count, J[p]);
    }
    weight.fill(0);
    load_row(terms.weight, first, count, weight);
    load_row(terms.residual, first, count, residual);
    load_row(terms.v, first, count, image[0]);
    load_row(terms.u, first, count, image[1]);
    for (std::size_t i = 0; i < count; ++i) {
      points[0][i] = static_cast<float>(view.points.pixel[first + i].y);
      points[1][i] = static_cast<float>(view.points.pixel[first + i].x);
    }
    const float inverse_height = 1 / static_cast<float>(view.image.camera.height);
    const float inverse_width = 1 / static_cast<float>(view.image.camera.width);
    for (LinePlaces* places : {&points, &image}) {
      for (std::size_t i = 0; i < kBlock; ++i) {
        (*places)[0][i] = past_middle((*places)[0][i], inverse_height);
        (*places)[1][i] = past_middle((*places)[1][i], inverse_width);
      }
    }
  }
};

EDVO_INLINE void multiply(const BlockRow& a, const BlockRow& b, BlockRow& product) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    product[i] = a[i] * b[i];
  }
}

/// Sums w s J J^T, whose upper square is symmetric, over blocks of points.
struct alignas(64) LineMoment {
  static constexpr std::size_t kSums = 6 * 7 / 2 + 2 * 6;

  std::array<Lanes, kSums> sums{};  // of each of the first six columns the rows from it on

  EDVO_INLINE void add(const MomentBlock& block, const BlockRow& place) {
    BlockRow weighted, product;
    multiply(block.weight, place, weighted);
    std::size_t k = 0;
    for (std::size_t column = 0; column < kPoseParameters; ++column) {
      multiply(weighted, block.J[column], product);
      for (std::size_t row = column; row < kPassParameters; ++row, ++k) {
        add_products(product, block.J[row], sums[k]);
      }
    }
  }

  RollingShutterMoments::Moment moment() const {
    RollingShutterMoments::Moment result;
    std::size_t k = 0;
    for (Eigen::Index column = 0; column < result.cols(); ++column) {
      for (Eigen::Index row = column; row < result.rows(); ++row, ++k) {
        result(row, column) = total(sums[k]);
        if (row < result.cols()) {
          result(column, row) = result(row, column);
        }
      }
    }
    return result;
  }
};

struct LineMoments {
  LineMoment points, image;
};

EDVO_INLINE void sum_moments(const PointView& view, const PointTerms& terms, ReadoutAxis axis,
                             LineMoments& moments) {
  const auto k = static_cast<std::size_t>(axis);
  MomentBlock block{};
  for (std::size_t first = 0; first < terms.weight.size(); first += kBlock) {
    block.load(view, terms, first);
    moments.points.add(block, block.points[k]);
    moments.image.add(block, block.image[k]);
  }
}

void sum_moments_baseline(const PointView& view, const PointTerms& terms, ReadoutAxis axis,
                          LineMoments& moments) {
  sum_moments(view, terms, axis, moments);
}

EDVO_TARGET_AVX2 void sum_moments_avx2(const PointView& view, const PointTerms& terms,
                                       ReadoutAxis axis, LineMoments& moments) {
  sum_moments(view, terms, axis, moments);
}

EDVO_TARGET_AVX512 void sum_moments_avx512(const PointView& view, const PointTerms& terms,
                                           ReadoutAxis axis, LineMoments& moments) {
  sum_moments(view, terms, axis, moments);
}

using Twist = std::array<float, kPoseParameters>;

Twist twist_of(const Vector6d& twist) {
  Twist result;
  Eigen::Map<Eigen::Matrix<float, 6, 1>>(result.data()) = twist.cast<float>();
  return result;
}

/// The velocities while the points' frame and the image were read.
struct TwistPair {
  Twist points, image;
};

/// Sums the products of q = dr / dt with itself, the residual and the Jacobian.
struct alignas(64) ReadoutSums {
  std::array<Lanes, 3> square{};  // rows by rows, rows by columns, columns by columns
  std::array<Lanes, 2> by_residual{};
  std::array<std::array<Lanes, 2>, kPassParameters> coupling{};

  EDVO_INLINE void add(const MomentBlock& block, const TwistPair& twists) {
    BlockRow by_points{};
    BlockRow by_image{};
    for (std::size_t p = 0; p < kPoseParameters; ++p) {
      for (std::size_t i = 0; i < kBlock; ++i) {
        by_points[i] += block.J[p][i] * twists.points[p];
        by_image[i] += block.J[p][i] * twists.image[p];
      }
    }
    std::array<BlockRow, 2> q, weighted;
    for (std::size_t k = 0; k < q.size(); ++k) {
      for (std::size_t i = 0; i < kBlock; ++i) {
        q[k][i] = block.points[k][i] * by_points[i] - block.image[k][i] * by_image[i];
      }
      multiply(block.weight, q[k], weighted[k]);
      add_products(weighted[k], block.residual, by_residual[k]);
      for (std::size_t p = 0; p < kPassParameters; ++p) {
        add_products(weighted[k], block.J[p], coupling[p][k]);
      }
    }
    add_products(weighted[0], q[0], square[0]);
    add_products(weighted[0], q[1], square[1]);
    add_products(weighted[1], q[1], square[2]);
  }
};

EDVO_INLINE void sum_readout(const PointView& view, const PointTerms& terms,
                             const TwistPair& twists, ReadoutSums& sums) {
  MomentBlock block{};
  for (std::size_t first = 0; first < terms.weight.size(); first += kBlock) {
    block.load(view, terms, first);
    sums.add(block, twists);
  }
}

void sum_readout_baseline(const PointView& view, const PointTerms& terms, const TwistPair& twists,
                          ReadoutSums& sums) {
  sum_readout(view, terms, twists, sums);
}

EDVO_TARGET_AVX2 void sum_readout_avx2(const PointView& view, const PointTerms& terms,
                                       const TwistPair& twists, ReadoutSums& sums) {
  sum_readout(view, terms, twists, sums);
}

EDVO_TARGET_AVX512 void sum_readout_avx512(const PointView& view, const PointTerms& terms,
                                           const TwistPair& twists, ReadoutSums& sums) {
  sum_readout(view, terms, twists, sums);
}

}  // namespace

RollingShutterMoments RollingShutterMoments::of(const PointView& view, const PointTerms& scores,
                                                ReadoutAxis axis) {
  const InstructionSet set = available_instruction_set();
  const auto sum = version_for(set, sum_moments_baseline, sum_moments_avx2, sum_moments_avx512);
  LineMoments moments;
  sum(view, scores, axis, moments);
  return {moments.points.moment(), moments.image.moment()};
}

ReadoutMoments ReadoutMoments::of(const PointView& view, const PointTerms& scores,
                                  const Vector6d& points_twist, const Vector6d& image_twist) {
  const InstructionSet set = available_instruction_set();
  const auto sum = version_for(set, sum_readout_baseline, sum_readout_avx2, sum_readout_avx512);
  ReadoutSums sums;
  sum(view, scores, {twist_of(points_twist), twist_of(image_twist)}, sums);
  ReadoutMoments result;
  result.square << total(sums.square[0]), total(sums.square[1]), total(sums.square[1]),
      total(sums.square[2]);
  for (Eigen::Index k = 0; k < 2; ++k) {
    result.by_residual[k] = total(sums.by_residual.at(static_cast<std::size_t>(k)));
    for (std::size_t p = 0; p < kPassParameters; ++p) {
      result.coupling(static_cast<Eigen::Index>(p), k) =
          total(sums.coupling.at(p).at(static_cast<std::size_t>(k)));
    }
  }
  return result;
}

}  // namespace vo
