#pragma once

#include <cmath>

#include "vo/core/instruction_set.h"
#include "vo/image/vignette.h"

namespace vo::detail {

inline double inverse_square_of_half_diagonal(const PinholeCamera& camera) {
  const double diagonal = std::hypot(camera.width, camera.height);
  return 4 / (diagonal * diagonal);
}

/// The gains of a vignette at the pixels of a row.
struct RowGains {
  float cx, cy;          ///< px
  float inverse_square;  ///< 1 / (half the diagonal)^2, 1/px^2
  float c0, c1;          ///< the vignette's coefficients
  float dv2 = 0;         ///< px^2, squared distance of the row from the principal point

  RowGains(const Vignette& vignette, const PinholeCamera& camera)
      : cx(static_cast<float>(camera.cx)),
        cy(static_cast<float>(camera.cy)),
        inverse_square(static_cast<float>(inverse_square_of_half_diagonal(camera))),
        c0(static_cast<float>(vignette.coefficients[0])),
        c1(static_cast<float>(vignette.coefficients[1])) {}

  void go_to_row(int v) {
    const float dv = static_cast<float>(v) - cy;
    dv2 = dv * dv;
  }

  EDVO_INLINE float at(int u) const {
    const float du = static_cast<float>(u) - cx;
    const float rho2 = inverse_square * (du * du + dv2);
    return 1 + rho2 * (c0 + rho2 * c1);
  }
};

}  // namespace vo::detail
