#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "vo/residuals/warp.h"

/// What the passes over points compute, written one point at a time.
namespace support {

/// Row of the forward-compositional Jacobian (paper, Eq. 12): the derivative of I_cur(pi(exp(delta)
/// T_cur_ref p_ref)) by delta = [translation; rotation] at 0, given the current image's gradient
/// (intensity per px) at the warped pixel.
template <typename Scalar>
inline Eigen::Matrix<Scalar, 6, 1> forward_jacobian(const vo::WarpedPoint<Scalar>& point, Scalar gu,
                                                    Scalar gv) {
  const Scalar inverse_z = 1 / point.p_cur.z();
  const Scalar a = (gu * point.J_pixel_image(0, 0) + gv * point.J_pixel_image(1, 0)) * inverse_z;
  const Scalar b = (gu * point.J_pixel_image(0, 1) + gv * point.J_pixel_image(1, 1)) * inverse_z;
  const Scalar x = point.p_cur.x();
  const Scalar y = point.p_cur.y();
  const Scalar z = point.p_cur.z();
  const Scalar c = -(a * x + b * y) * inverse_z;
  Eigen::Matrix<Scalar, 6, 1> J;
  J << a, b, c, y * c - z * b, z * a - x * c, x * b - y * a;
  return J;
}

/// Bilinear look-up at (u, v) with 0 <= u < width - 1, 0 <= v < height - 1.
struct BilinearWeights {
  int u, v;
  float w00, w10, w01, w11;

  BilinearWeights(float pixel_u, float pixel_v)
      : u(static_cast<int>(pixel_u)), v(static_cast<int>(pixel_v)) {
    const float du = pixel_u - static_cast<float>(u);
    const float dv = pixel_v - static_cast<float>(v);
    w11 = du * dv;
    w10 = du - w11;
    w01 = dv - w11;
    w00 = 1 - du - w01;
  }

  template <typename Pixel>
  Pixel operator()(const cv::Mat_<Pixel>& image) const {
    const Pixel* upper = image[v] + u;
    const Pixel* lower = image[v + 1] + u;
    return upper[0] * w00 + upper[1] * w10 + lower[0] * w01 + lower[1] * w11;
  }
};

}  // namespace support
