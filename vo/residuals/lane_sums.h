#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "vo/residuals/point_block.h"

/// Sums over blocks of points, lane by lane, so that all instruction sets give identical bits.
namespace vo::detail {

inline constexpr std::size_t kLanes = 16;  // floats of the widest register
inline constexpr std::size_t kFlushPeriod =
    8;  // blocks summed in float before they are added in double

using Lanes = std::array<float, kLanes>;

/// The widest register, or as many narrower ones as hold its lanes.
using WideLanes = float __attribute__((vector_size(kLanes * sizeof(float))));

EDVO_INLINE void load_lanes(const float* values, WideLanes& lanes) {
  std::memcpy(&lanes, values, sizeof(lanes));
}

/// A row of a block in registers.
struct WideRow {
  std::array<WideLanes, kBlock / kLanes> part;

  /// Loads the product of two rows.
  EDVO_INLINE WideRow(const BlockRow& a, const BlockRow& b) {
    WideLanes factor;
    for (std::size_t k = 0; k < part.size(); ++k) {
      load_lanes(a.data() + k * kLanes, part[k]);
      load_lanes(b.data() + k * kLanes, factor);
      part[k] *= factor;
    }
  }
};

EDVO_INLINE void add_products(const WideRow& a, const BlockRow& b, Lanes& sum) {
  WideLanes lanes, factor;
  load_lanes(sum.data(), lanes);
  for (std::size_t k = 0; k < a.part.size(); ++k) {
    load_lanes(b.data() + k * kLanes, factor);
    lanes += a.part[k] * factor;
  }
  std::memcpy(sum.data(), &lanes, sizeof(lanes));
}

EDVO_INLINE void add_products(const BlockRow& a, const BlockRow& b, Lanes& sum) {
  for (std::size_t start = 0; start < kBlock; start += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      sum[lane] += a[start + lane] * b[start + lane];
    }
  }
}

EDVO_INLINE void add_values(const BlockRow& a, Lanes& sum) {
  for (std::size_t start = 0; start < kBlock; start += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      sum[lane] += a[start + lane];
    }
  }
}

/// Returns the sum of all lanes, in their order.
inline double total(const Lanes& lanes) {
  double sum = 0;
  for (const float value : lanes) {
    sum += static_cast<double>(value);
  }
  return sum;
}

/// The sums over some blocks in single precision, lane by lane.
struct alignas(64) LaneSums {
  static constexpr std::size_t kPairs = kPassParameters * (kPassParameters + 1) / 2;

  std::array<Lanes, kPairs> H{};  // upper triangle, row by row
  std::array<Lanes, kPassParameters> b{};
  Lanes loss{};

  EDVO_INLINE void add(std::size_t parameters, const Block& block) {
    for (std::size_t p = 0; p < parameters; ++p) {
      const WideRow weighted(block.weight, block.J[p]);
      const std::size_t row = p * kPassParameters - p * (p + 1) / 2;  // H[row + q] is of p and q
      for (std::size_t q = p; q < parameters; ++q) {
        add_products(weighted, block.J[q], H[row + q]);
      }
      add_products(weighted, block.residual, b[p]);
    }
    add_values(block.loss, loss);
  }

  void flush_into(NormalEquations<kPassParameters>& sums) {
    std::size_t pair = 0;
    for (std::size_t p = 0; p < kPassParameters; ++p) {
      const auto row = static_cast<Eigen::Index>(p);
      for (Eigen::Index column = row; column < sums.H.cols(); ++column, ++pair) {
        sums.H(row, column) += total(H[pair]);
        sums.H(column, row) = sums.H(row, column);
      }
      sums.b[row] += total(b[p]);
    }
    sums.cost += total(loss);
    *this = {};
  }
};

}  // namespace vo::detail
