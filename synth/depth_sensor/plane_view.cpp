#include "synth/depth_sensor/plane_view.h"

#include <cmath>
#include <numbers>

namespace synth {

DepthView plane_view(const vo::PinholeCamera& camera, double depth, double lean_deg) {
  const double lean = lean_deg * std::numbers::pi / 180;
  const Eigen::Vector3d normal(std::sin(lean), 0, -std::cos(lean));
  const cv::Vec3f towards_camera(static_cast<float>(normal.x()), 0, static_cast<float>(normal.z()));
  DepthView view{vo::DepthImage(camera.height, camera.width, 0.0F),
                 cv::Mat_<cv::Vec3f>(camera.height, camera.width, towards_camera)};
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double along = normal.dot(camera.unproject(Eigen::Vector2d(u, v), 1));
      view.depth(v, u) = along < 0 ? static_cast<float>(normal.z() * depth / along) : 0.0F;
    }
  }
  return view;
}

}  // namespace synth
