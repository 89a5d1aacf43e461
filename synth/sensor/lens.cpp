#include "synth/sensor/lens.h"

#include <algorithm>
#include <cmath>

#include "synth/depth_sensor/gaussian.h"
#include "vo/core/error.h"

namespace synth {

void LensOptions::validate() const {
  constexpr double kMaxBlur = 50;  // px
  vo::require(blur >= 0 && blur <= kMaxBlur, "sensor.lens.blur: expected 0 to ", kMaxBlur,
              " px, got ", blur);
  vo::require(vignetting.cos_power >= 0 && std::isfinite(vignetting.cos_power) &&
                  std::isfinite(vignetting.k2 + vignetting.k4 + vignetting.k6),
              "sensor.lens.vignetting: expected cos_power at or above 0 and finite coefficients");
}

double light_share(const vo::PinholeCamera& camera, const Eigen::Vector2d& pixel,
                   const Vignetting& vignetting) {
  const Eigen::Vector2d offset = pixel - Eigen::Vector2d(camera.cx, camera.cy);
  const double half_diagonal = std::hypot(camera.width, camera.height) / 2;
  const double r2 = offset.squaredNorm() / (half_diagonal * half_diagonal);
  const double polynomial = 1 + r2 * (vignetting.k2 + r2 * (vignetting.k4 + r2 * vignetting.k6));
  const double cosine = 1 / camera.unproject(pixel, 1).norm();
  if (std::isnan(cosine)) {
    return 0;
  }
  return std::max(0.0, polynomial) * std::pow(cosine, vignetting.cos_power);
}

cv::Mat_<cv::Vec3f> through_lens(const cv::Mat_<cv::Vec3f>& radiance, const vo::CameraModel& camera,
                                 const LensOptions& options) {
  if (options.is_perfect()) {
    return radiance;
  }
  const vo::PinholeCamera& pinhole = camera.pinhole_for("sensor.lens");
  cv::Mat_<cv::Vec3f> light = options.blur > 0 ? blurred(radiance, options.blur) : radiance;
  if (options.vignetting.is_zero()) {
    return light;
  }
  light = light.clone();
  for (int v = 0; v < light.rows; ++v) {
    for (int u = 0; u < light.cols; ++u) {
      light(v, u) *=
          static_cast<float>(light_share(pinhole, Eigen::Vector2d(u, v), options.vignetting));
    }
  }
  return light;
}

}  // namespace synth
