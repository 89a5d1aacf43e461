#pragma once

#include <Eigen/Core>

#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"

namespace vo {

/// A frame's estimated pose and brightness relative to the host.
struct FrameRelation {
  SE3 T_cur_host;
  Matrix6d covariance = Matrix6d::Zero();  ///< covariance of the left increment of T_cur_host
  double gain = 1;                         ///< the current image shows gain I_host + offset
  double offset = 0;                       ///< intensity, offset of the brightness
  ReadoutMotion host_motion = {};          ///< motion while the host was read
  ReadoutMotion current_motion = {};       ///< motion while the current image was read
};

/// The transforms [R | t] from the camera of a host's line to the camera of a current line, m,
/// linear in how far each line is past its image's middle line: of the shares s_host and s_current
/// of the images' sizes it is `of_middle + s_host by_host_line + s_current (by_current_line +
/// s_host by_both)`.
struct LineTransforms {
  using Matrix34f = Eigen::Matrix<float, 3, 4>;

  bool is_rolling = false;  ///< whether the transform differs from line to line
  ReadoutAxis host_axis = ReadoutAxis::rows;
  ReadoutAxis current_axis = ReadoutAxis::rows;
  Matrix34f of_middle = Matrix34f::Zero();
  Matrix34f by_host_line = Matrix34f::Zero();
  Matrix34f by_current_line = Matrix34f::Zero();
  Matrix34f by_both = Matrix34f::Zero();

  explicit LineTransforms(const FrameRelation& relation);
};

/// Two images and the geometry between them, in the precision of the loop over pixels.
struct StereoPair {
  const PyramidLevel& host;
  const PyramidLevel& current;
  Eigen::Vector3f p_host_cur;  ///< m, the current camera's centre in the host frame
  Eigen::Matrix<float, 6, 6> covariance;
  bool pose_is_exact;
  LineTransforms lines;
  float gain;
  float offset;

  StereoPair(const PyramidLevel& host_level, const PyramidLevel& current_level,
             const FrameRelation& relation)
      : host(host_level),
        current(current_level),
        p_host_cur(relation.T_cur_host.inverse().translation().cast<float>()),
        covariance(relation.covariance.cast<float>()),
        pose_is_exact(relation.covariance.isZero(0)),
        lines(relation),
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
