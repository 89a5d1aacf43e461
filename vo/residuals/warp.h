#pragma once

#include <Eigen/Core>

#include "vo/geometry/camera.h"
#include "vo/geometry/projection.h"
#include "vo/geometry/se3.h"

namespace vo {

/// A rigid transform and a camera in the precision of the point loop (float) or of a test (double).
/// The innermost loops use their own for blocks of points (point_block.h).
template <typename Scalar>
struct Warp {
  Eigen::Matrix<Scalar, 3, 3> R_cur_ref;
  Eigen::Matrix<Scalar, 3, 1> t_cur_ref;  ///< m
  Projection<Scalar> projection;

  Warp(const PinholeCamera& camera, const SE3& T_cur_ref)
      : R_cur_ref(T_cur_ref.rotation_matrix().cast<Scalar>()),
        t_cur_ref(T_cur_ref.translation().cast<Scalar>()),
        projection(camera) {}
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
  const ImagedDirection<Scalar> imaged = image_direction(
      warp.projection, Scalar(point.p_cur.x() * inverse_z), Scalar(point.p_cur.y() * inverse_z));
  point.u = imaged.u;
  point.v = imaged.v;
  point.J_pixel_image << imaged.du_dx, imaged.du_dy, imaged.dv_dx, imaged.dv_dy;
  return point;
}

/// Returns whether a warped point is in view: in front of the camera and inside its image. Not all
/// that is in view is seen (`SeenBounds`).
template <typename Scalar>
inline bool is_in_view(const WarpedPoint<Scalar>& point, const PinholeCamera& camera) {
  return point.p_cur.z() > 0 && camera.contains({point.u, point.v});
}

}  // namespace vo
