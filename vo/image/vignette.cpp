#include "vo/image/vignette.h"

#include "vo/core/instruction_set.h"
#include "vo/image/vignette_gains.h"

namespace vo {
namespace {

using detail::RowGains;

/// The factors of one row's intensities: the gain of `now` over that of `before`. With no vignette
/// before, the factors are exactly the gains of `now`.
struct RowFactors {
  RowGains now;
  RowGains before;
  bool has_before;

  template <bool kHasBefore>
  EDVO_INLINE void apply(float* __restrict row, int cols) const {
    for (int u = 0; u < cols; ++u) {
      row[u] *= kHasBefore ? now.at(u) / before.at(u) : now.at(u);
    }
  }

  EDVO_INLINE void apply(float* row, int cols) const {
    if (has_before) {
      apply<true>(row, cols);
    } else {
      apply<false>(row, cols);
    }
  }
};

EDVO_TARGET_AVX2 void apply_avx2(const RowFactors& factors, float* row, int cols) {
  factors.apply(row, cols);
}

void apply_baseline(const RowFactors& factors, float* row, int cols) {
  factors.apply(row, cols);
}

}  // namespace

VignetteTerms::VignetteTerms(const PinholeCamera& camera)
    : cx_(camera.cx),
      cy_(camera.cy),
      inverse_square_(detail::inverse_square_of_half_diagonal(camera)) {}

void take_out(const Vignette& vignette, const PinholeCamera& camera, const Vignette& before,
              GrayImage& image) {
  if (vignette == before) {
    return;
  }
  const auto apply =
      available_instruction_set() == InstructionSet::baseline ? apply_baseline : apply_avx2;
  RowFactors factors{{vignette, camera}, {before, camera}, !(before == Vignette())};
  for (int v = 0; v < image.rows; ++v) {
    factors.now.go_to_row(v);
    factors.before.go_to_row(v);
    apply(factors, image[v], image.cols);
  }
}

}  // namespace vo
