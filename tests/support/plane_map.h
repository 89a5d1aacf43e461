#pragma once

#include "tests/support/plane_frames.h"
#include "vo/image/pyramid.h"
#include "vo/mapping/depth_map.h"

namespace support {

/// The textured plane as a monocular frame: no depth, with edges.
inline vo::FramePyramid grey_frame(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera,
                                   int index = 0) {
  vo::RgbdFrame frame = plane_frame(camera, T_world_camera, index);
  frame.depth = vo::DepthImage();
  vo::FramePyramid pyramid = vo::build_pyramid(frame, camera, vo::PyramidOptions());
  vo::add_edges(pyramid, vo::EdgeOptions());
  return pyramid;
}

/// The true inverse depth of the plane at a pixel, 1/m.
inline double true_inverse_depth(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera,
                                 double u, double v) {
  return 1 / TexturedPlane().depth(camera, T_world_camera, {u, v});
}

/// True relative errors of what a map holds, known hypotheses only.
inline std::vector<double> relative_errors(const vo::DepthMap& map, const vo::PinholeCamera& camera,
                                           const vo::SE3& T_world_host) {
  std::vector<double> errors;
  const vo::Hypotheses& hypotheses = map.hypotheses();
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.state[i] == vo::DepthState::known &&
        hypotheses.relative_sigma(i) < vo::kConfidentSigma) {
      const cv::Point pixel = hypotheses.pixel[i];
      errors.push_back(hypotheses.inverse_depth[i] /
                           true_inverse_depth(camera, T_world_host, pixel.x, pixel.y) -
                       1);
    }
  }
  return errors;
}

inline double median_magnitude(std::vector<double> values) {
  for (double& value : values) {
    value = std::abs(value);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace support
