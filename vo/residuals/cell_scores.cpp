#include "vo/residuals/cell_scores.h"

#include <algorithm>
#include <array>

#include "vo/core/instruction_set.h"

namespace vo {
namespace {

constexpr int kColumns = 16;
constexpr std::size_t kPointsAtOnce = 64;

/// Sums of the points' terms of b, one for each cell.
using CellSums = std::vector<PointEquations::Vector>;

/// The cells of the points, and their terms of b side by side, of which 64 are computed at once.
struct alignas(64) PointScores {
  std::array<int, kPointsAtOnce> cell;
  std::array<std::array<float, kPassParameters>, kPointsAtOnce> term;

  EDVO_INLINE void compute(const PointTerms& terms, float cell_px, std::size_t first,
                           std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      cell[i] = kColumns * static_cast<int>((terms.v[first + i] + 0.5F) / cell_px) +
                static_cast<int>((terms.u[first + i] + 0.5F) / cell_px);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const float weighted = terms.weight[first + i] * terms.residual[first + i];
      for (std::size_t p = 0; p < kPassParameters; ++p) {
        term[i][p] = weighted * terms.J[p][first + i];
      }
    }
  }

  EDVO_INLINE void add_to(CellSums& sums, std::size_t i) const {
    double* sum = sums[static_cast<std::size_t>(cell[i])].data();
    for (std::size_t p = 0; p < kPassParameters; ++p) {
      sum[p] += static_cast<double>(term[i][p]);
    }
  }
};

EDVO_INLINE void add_points(const PointTerms& terms, float cell_px, CellSums& sums) {
  PointScores scores;
  for (std::size_t first = 0; first < terms.weight.size(); first += kPointsAtOnce) {
    const std::size_t count = std::min(kPointsAtOnce, terms.weight.size() - first);
    scores.compute(terms, cell_px, first, count);
    for (std::size_t i = 0; i < count; ++i) {
      if (terms.weight[first + i] > 0) {
        scores.add_to(sums, i);
      }
    }
  }
}

void add_points_baseline(const PointTerms& terms, float cell_px, CellSums& sums) {
  add_points(terms, cell_px, sums);
}

EDVO_TARGET_AVX2 void add_points_avx2(const PointTerms& terms, float cell_px, CellSums& sums) {
  add_points(terms, cell_px, sums);
}

}  // namespace

void CellScores::reset(const PinholeCamera& camera) {
  cell_px_ = static_cast<float>(camera.width) / kColumns;
  const auto last_row = static_cast<float>(camera.height - 1);
  b_.assign(cell_of(0, last_row) + kColumns, Vector6d::Zero());
}

void CellScores::add(const PointTerms& scores, const Projection& projection) {
  sums_.assign(b_.size(), PointEquations::Vector::Zero());
  const bool is_baseline = available_instruction_set() == InstructionSet::baseline;
  (is_baseline ? add_points_baseline : add_points_avx2)(scores, cell_px_, sums_);
  for (std::size_t cell = 0; cell < b_.size(); ++cell) {
    b_[cell] += projection * sums_[cell];
  }
}

void CellScores::add(float u, float v, const Vector6d& b) {
  b_[cell_of(u, v)] += b;
}

std::size_t CellScores::cell_of(float u, float v) const {
  return kColumns * static_cast<std::size_t>((v + 0.5F) / cell_px_) +
         static_cast<std::size_t>((u + 0.5F) / cell_px_);
}

}  // namespace vo
