#pragma once

#include <opencv2/core.hpp>

#include "vo/geometry/camera_model.h"

namespace synth {

/// Vignetting, the loss of light towards the image's corners, by the factor cos(a)^cos_power (1 +
/// k2 r^2 + k4 r^4 + k6 r^6), a being the angle off the optical axis and r the distance from the
/// principal point over half the image's diagonal.
struct Vignetting {
  double cos_power = 0;  ///< exponent of the cosine; 4 = thin lens
  double k2 = 0;
  double k4 = 0;
  double k6 = 0;

  bool is_zero() const { return cos_power == 0 && k2 == 0 && k4 == 0 && k6 == 0; }
};

/// The effects of the lens besides distortion, which the camera model has.
struct LensOptions {
  double blur = 0;  ///< px, standard deviation of the Gaussian point-spread function
  Vignetting vignetting;

  bool is_perfect() const { return blur == 0 && vignetting.is_zero(); }
  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, Vignetting& vignetting) {
  visit("cos_power", vignetting.cos_power, "power of the cosine off the optical axis; 4 = natural");
  visit("k2", vignetting.k2, "polynomial, r^2, r = 1 at half the diagonal");
  visit("k4", vignetting.k4, "polynomial, r^4");
  visit("k6", vignetting.k6, "polynomial, r^6");
}

template <typename Visitor>
void visit_fields(Visitor& visit, LensOptions& options) {
  visit("blur", options.blur, "standard deviation of the point-spread function, px");
  visit("vignetting", options.vignetting, "");
}

/// Returns the share of the light that reaches a pixel; 0 where the lens sees nothing.
double light_share(const vo::PinholeCamera& camera, const Eigen::Vector2d& pixel,
                   const Vignetting& vignetting);

/// Returns the linear light on the sensor: the radiance after blur and vignetting, which are of
/// pinhole cameras; throws vo::Error where they are on and the camera is another.
cv::Mat_<cv::Vec3f> through_lens(const cv::Mat_<cv::Vec3f>& radiance, const vo::CameraModel& camera,
                                 const LensOptions& options);

}  // namespace synth
