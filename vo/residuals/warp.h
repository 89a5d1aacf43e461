#pragma once

#include <Eigen/Core>

#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace vo {

/// A rigid transform and a camera in the precision of the point loop (float) or of a test (double).
/// The innermost loops use their own for blocks of points (point_block.h).
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

/// The position of a reference point in the current camera's frame and image.
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

/// Returns whether a warped point is in front of the camera and inside its image.
template <typename Scalar>
inline bool is_seen(const WarpedPoint<Scalar>& point, const PinholeCamera& camera) {
  return point.p_cur.z() > 0 && camera.contains({point.u, point.v});
}

}  // namespace vo
