#pragma once

#include <utility>

#include <ceres/jet.h>

#include "tests/support/warp_oracle.h"
#include "vo/image/pyramid.h"

namespace support {

/// The level's interpolated image as Ceres sees it: value and gradient at a point, and the chain
/// rule for automatic derivatives.
class ImageFunction {
 public:
  explicit ImageFunction(const vo::PyramidLevel& level)
      : level_(level), gradient_(level.intensity.size()) {
    for (int v = 0; v < gradient_.rows; ++v) {
      for (int u = 0; u < gradient_.cols; ++u) {
        gradient_(v, u) = vo::central_gradient(level.intensity, {u, v});
      }
    }
  }

  double operator()(double u, double v) const { return look_up(u, v).first; }

  template <int N>
  ceres::Jet<double, N> operator()(const ceres::Jet<double, N>& u,
                                   const ceres::Jet<double, N>& v) const {
    const auto [value, gradient] = look_up(u.a, v.a);
    return {value, gradient[0] * u.v + gradient[1] * v.v};
  }

 private:
  std::pair<double, cv::Vec2f> look_up(double u, double v) const {
    const BilinearWeights at(static_cast<float>(u), static_cast<float>(v));
    return {at(level_.intensity), at(gradient_)};
  }

  const vo::PyramidLevel& level_;
  cv::Mat_<cv::Vec2f> gradient_;
};

}  // namespace support
