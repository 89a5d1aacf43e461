#include "vo/image/vignette.h"

#include <cmath>

namespace vo {
namespace {

double inverse_square_of_half_diagonal(const PinholeCamera& camera) {
  const double diagonal = std::hypot(camera.width, camera.height);
  return 4 / (diagonal * diagonal);
}

}  // namespace

VignetteTerms::VignetteTerms(const PinholeCamera& camera)
    : cx_(camera.cx), cy_(camera.cy), inverse_square_(inverse_square_of_half_diagonal(camera)) {}

void take_out(const Vignette& vignette, const PinholeCamera& camera, const Vignette& before,
              GrayImage& image) {
  if (vignette == before) {
    return;
  }
  const auto inverse_square = static_cast<float>(inverse_square_of_half_diagonal(camera));
  const Eigen::Vector2f now = vignette.coefficients.cast<float>();
  const Eigen::Vector2f then = before.coefficients.cast<float>();
  const auto cx = static_cast<float>(camera.cx);
  const auto cy = static_cast<float>(camera.cy);
  for (int v = 0; v < image.rows; ++v) {
    const float dv = static_cast<float>(v) - cy;
    float* row = image[v];
    for (int u = 0; u < image.cols; ++u) {
      const float du = static_cast<float>(u) - cx;
      const float rho2 = inverse_square * (du * du + dv * dv);
      row[u] *= (1 + rho2 * (now[0] + rho2 * now[1])) / (1 + rho2 * (then[0] + rho2 * then[1]));
    }
  }
}

}  // namespace vo
