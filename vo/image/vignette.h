#pragma once

#include <Eigen/Core>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace vo {

/// A lens's darkening of an image towards its corners. The scene's intensities are the image's
/// times 1 + c_0 rho^2 + c_1 rho^4, where rho is the distance from the principal point, 1 at half
/// the diagonal. Goldman, "Vignette and Exposure Calibration and Compensation" (PAMI 2010) has the
/// inverse of such a polynomial.
struct Vignette {
  Eigen::Vector2d coefficients = Eigen::Vector2d::Zero();

  double gain(const Eigen::Vector2d& terms) const { return 1 + coefficients.dot(terms); }
  bool operator==(const Vignette& other) const { return coefficients == other.coefficients; }
};

/// Computes the powers of rho that the coefficients of a camera's vignette multiply.
class VignetteTerms {
 public:
  explicit VignetteTerms(const PinholeCamera& camera);

  /// Returns (rho^2, rho^4) at a pixel.
  Eigen::Vector2d at(double u, double v) const {
    const double du = u - cx_;
    const double dv = v - cy_;
    const double rho2 = inverse_square_ * (du * du + dv * dv);
    return {rho2, rho2 * rho2};
  }

 private:
  double cx_, cy_;         ///< px
  double inverse_square_;  ///< 1 / (half the diagonal)^2, 1/px^2
};

/// Removes `vignette` from an image of this camera that `before` had been removed from: the result
/// is as if only `vignette` had ever been removed.
void take_out(const Vignette& vignette, const PinholeCamera& camera, const Vignette& before,
              GrayImage& image);

}  // namespace vo
