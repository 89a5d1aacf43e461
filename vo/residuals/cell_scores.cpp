#include "vo/residuals/cell_scores.h"

namespace vo {
namespace {

constexpr int kColumns = 16;

}  // namespace

void CellScores::reset(const PinholeCamera& camera) {
  cell_px_ = static_cast<float>(camera.width) / kColumns;
  const auto last_row = static_cast<float>(camera.height - 1);
  b_.assign(cell_of(0, last_row) + kColumns, Vector6d::Zero());
}

void CellScores::add(const PointTerms& scores, const Projection& projection) {
  using Sum = PointEquations::Vector;
  sums_.assign(b_.size(), Sum::Zero());
  for (std::size_t i = 0; i < scores.weight.size(); ++i) {
    if (scores.weight[i] > 0) {
      Sum& sum = sums_[cell_of(scores.u[i], scores.v[i])];
      const float weighted = scores.weight[i] * scores.residual[i];
      for (std::size_t p = 0; p < kPassParameters; ++p) {
        sum[static_cast<Eigen::Index>(p)] += static_cast<double>(weighted * scores.J[p][i]);
      }
    }
  }
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
