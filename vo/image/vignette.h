#pragma once

#include <Eigen/Core>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace vo {

/// How much darker a lens makes an image towards its corners. Intensities of the scene are those of
/// the image times 1 + c_0 rho^2 + c_1 rho^4, rho = distance from the principal point, 1 at half
/// the diagonal. Goldman, "Vignette and Exposure Calibration and Compensation" (PAMI 2010) has the
/// inverse of such a polynomial.
struct Vignette {
  Eigen::Vector2d coefficients = Eigen::Vector2d::Zero();

  double gain(const Eigen::Vector2d& terms) const { return 1 + coefficients.dot(terms); }
  bool operator==(const Vignette& other) const { return coefficients == other.coefficients; }
};

/// What the coefficients are factors of.
class VignetteTerms {
 public:
  explicit VignetteTerms(const PinholeCamera& camera);

  /// (rho^2, rho^4)
  Eigen::Vector2d at(double u, double v) const {
    const double du = u - cx_;
    const double dv = v - cy_;
    const double rho2 = inverse_square_ * (du * du + dv * dv);
    return {rho2, rho2 * rho2};
  }

 private:
  double cx_, cy_;         ///< px
  double inverse_square_;  ///< of half the diagonal, 1/px^2
};

/// Makes an image of this camera, which another vignette was taken out of before, what it would be
/// without this one.
void take_out(const Vignette& vignette, const PinholeCamera& camera, const Vignette& before,
              GrayImage& image);

}  // namespace vo
