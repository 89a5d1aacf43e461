#pragma once

#include <Eigen/Core>

#include "vo/core/camera.h"
#include "vo/core/image.h"
#include "vo/core/se3.h"

namespace vo {

/// A rigid transform and a camera in the precision of the point loop (float) or of a test (double).
/// Everything is inline: it is the innermost code of the tracker.
template <typename Scalar>
struct Warp {
  Eigen::Matrix<Scalar, 3, 3> R_cur_ref;
  Eigen::Matrix<Scalar, 3, 1> t_cur_ref;  ///< m
  Scalar fx, fy, cx, cy;                  ///< px
  Distortion lens;
  bool distorted;

  Warp(const PinholeCamera& camera, const SE3& T_cur_ref)
      : R_cur_ref(T_cur_ref.rotation_matrix().cast<Scalar>()),
        t_cur_ref(T_cur_ref.translation().cast<Scalar>()),
        fx(Scalar(camera.fx)),
        fy(Scalar(camera.fy)),
        cx(Scalar(camera.cx)),
        cy(Scalar(camera.cy)),
        lens(camera.distortion),
        distorted(!camera.distortion.is_zero()) {}
};

/// Where a point of the reference appears in the current image.
template <typename Scalar>
struct WarpedPoint {
  Eigen::Matrix<Scalar, 3, 1> p_cur;          ///< m
  Scalar u, v;                                ///< px; valid for p_cur.z() > 0
  Eigen::Matrix<Scalar, 2, 2> J_pixel_image;  ///< d(u, v) / d(X / Z, Y / Z)
};

template <typename Scalar>
inline WarpedPoint<Scalar> warp_point(const Warp<Scalar>& warp,
                                      const Eigen::Matrix<Scalar, 3, 1>& p_ref) {
  WarpedPoint<Scalar> point;
  point.p_cur = warp.R_cur_ref * p_ref + warp.t_cur_ref;
  const Scalar inverse_z = 1 / point.p_cur.z();
  Scalar x = point.p_cur.x() * inverse_z;
  Scalar y = point.p_cur.y() * inverse_z;
  point.J_pixel_image << warp.fx, 0, 0, warp.fy;
  if (warp.distorted) {
    const DistortedPoint<Scalar> imaged = distort(warp.lens, x, y);
    point.J_pixel_image << warp.fx * imaged.dx_dx, warp.fx * imaged.dx_dy, warp.fy * imaged.dx_dy,
        warp.fy * imaged.dy_dy;
    x = imaged.x;
    y = imaged.y;
  }
  point.u = warp.fx * x + warp.cx;
  point.v = warp.fy * y + warp.cy;
  return point;
}

/// Row of the forward-compositional Jacobian (paper, Eq. 12): the derivative of I_cur(pi(exp(delta)
/// T_cur_ref p_ref)) by delta = [translation; rotation] at 0, given the current image's gradient
/// (intensity per px) at the warped pixel.
template <typename Scalar>
inline Eigen::Matrix<Scalar, 6, 1> forward_jacobian(const WarpedPoint<Scalar>& point, Scalar gu,
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

}  // namespace vo
