#pragma once

#include <Eigen/Core>

#include "vo/geometry/row_motion.h"
#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"

namespace vo {

/// A frame's estimated pose and brightness relative to the host.
struct FrameRelation {
  SE3 T_cur_host;
  Matrix6d covariance = Matrix6d::Zero();  ///< covariance of the left increment of T_cur_host
  double gain = 1;                         ///< the current image shows gain I_host + offset
  double offset = 0;                       ///< intensity, offset of the brightness
  RowMotion host_motion = {};              ///< motion of the host's rows
  RowMotion current_motion = {};           ///< motion of the current image's rows
};

/// The transforms [R | t] from the camera of a host's row to the camera of a current row, m, linear
/// in how far each row is below its image's middle row: of s_host and s_current image heights it is
/// `of_middle + s_host by_host_row + s_current (by_current_row + s_host by_both)`.
struct RowTransforms {
  using Matrix34f = Eigen::Matrix<float, 3, 4>;

  bool is_rolling = false;  ///< whether the transform differs from row to row
  Matrix34f of_middle = Matrix34f::Zero();
  Matrix34f by_host_row = Matrix34f::Zero();
  Matrix34f by_current_row = Matrix34f::Zero();
  Matrix34f by_both = Matrix34f::Zero();

  explicit RowTransforms(const FrameRelation& relation);
};

/// Two images and the geometry between them, in the precision of the loop over pixels.
struct StereoPair {
  const PyramidLevel& host;
  const PyramidLevel& current;
  Eigen::Vector3f p_host_cur;  ///< m, the current camera's centre in the host frame
  Eigen::Matrix<float, 6, 6> covariance;
  bool pose_is_exact;
  RowTransforms rows;
  float gain;
  float offset;

  StereoPair(const PyramidLevel& host_level, const PyramidLevel& current_level,
             const FrameRelation& relation)
      : host(host_level),
        current(current_level),
        p_host_cur(relation.T_cur_host.inverse().translation().cast<float>()),
        covariance(relation.covariance.cast<float>()),
        pose_is_exact(relation.covariance.isZero(0)),
        rows(relation),
        gain(static_cast<float>(relation.gain)),
        offset(static_cast<float>(relation.offset)) {}
};

inline float sample_bilinear(const GrayImage& image, const Eigen::Vector2f& pixel) {
  const int u = static_cast<int>(pixel.x());
  const int v = static_cast<int>(pixel.y());
  const float du = pixel.x() - static_cast<float>(u);
  const float dv = pixel.y() - static_cast<float>(v);
  const float* upper = image[v] + u;
  const float* lower = image[v + 1] + u;
  const float above = upper[0] + du * (upper[1] - upper[0]);
  const float below = lower[0] + du * (lower[1] - lower[0]);
  return above + dv * (below - above);
}

}  // namespace vo
