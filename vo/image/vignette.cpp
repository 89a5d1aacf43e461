#include "vo/image/vignette.h"

#include <cmath>

#include "vo/core/instruction_set.h"

namespace vo {
namespace {

double inverse_square_of_half_diagonal(const PinholeCamera& camera) {
  const double diagonal = std::hypot(camera.width, camera.height);
  return 4 / (diagonal * diagonal);
}

/// The factors of one row's intensities: the gain of `now` over that of `before`. With no vignette
/// before, the factors are exactly the gains of `now`.
struct RowGains {
  float cx;              ///< px
  float dv2;             ///< px^2, squared distance of the row from the principal point
  float inverse_square;  ///< 1 / (half the diagonal)^2, 1/px^2
  Eigen::Vector2f now;
  Eigen::Vector2f before;

  template <bool kHasBefore>
  EDVO_INLINE void apply(float* __restrict row, int cols) const {
    for (int u = 0; u < cols; ++u) {
      const float du = static_cast<float>(u) - cx;
      const float rho2 = inverse_square * (du * du + dv2);
      const float gain = 1 + rho2 * (now[0] + rho2 * now[1]);
      row[u] *= kHasBefore ? gain / (1 + rho2 * (before[0] + rho2 * before[1])) : gain;
    }
  }

  EDVO_INLINE void apply(float* row, int cols) const {
    if (before.isZero(0)) {
      apply<false>(row, cols);
    } else {
      apply<true>(row, cols);
    }
  }
};

EDVO_TARGET_AVX2 void apply_avx2(const RowGains& gains, float* row, int cols) {
  gains.apply(row, cols);
}

void apply_baseline(const RowGains& gains, float* row, int cols) {
  gains.apply(row, cols);
}

}  // namespace

VignetteTerms::VignetteTerms(const PinholeCamera& camera)
    : cx_(camera.cx), cy_(camera.cy), inverse_square_(inverse_square_of_half_diagonal(camera)) {}

void take_out(const Vignette& vignette, const PinholeCamera& camera, const Vignette& before,
              GrayImage& image) {
  if (vignette == before) {
    return;
  }
  const auto apply =
      available_instruction_set() == InstructionSet::baseline ? apply_baseline : apply_avx2;
  const auto inverse_square = static_cast<float>(inverse_square_of_half_diagonal(camera));
  const auto cy = static_cast<float>(camera.cy);
  for (int v = 0; v < image.rows; ++v) {
    const float dv = static_cast<float>(v) - cy;
    apply({.cx = static_cast<float>(camera.cx),
           .dv2 = dv * dv,
           .inverse_square = inverse_square,
           .now = vignette.coefficients.cast<float>(),
           .before = before.coefficients.cast<float>()},
          image[v], image.cols);
  }
}

}  // namespace vo
