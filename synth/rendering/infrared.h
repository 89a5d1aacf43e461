#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "vo/geometry/se3.h"

namespace synth {

/// A lamp of point size that throws a picture: its radiant intensity into a direction is the
/// picture's value there times `power`. It is fixed to the camera that sees its light, and moves
/// with it while a picture is exposed.
struct Projector {
  std::string name;
  vo::SE3 T_camera_projector;  ///< the projector is x right, y down, z forward, as a camera
  Eigen::Vector2d half_extent =
      Eigen::Vector2d::Ones();  ///< tan of half the fields of view, x and y
  double power = 1;             ///< cd, as that of the scene's lamps; linear, in all three channels
  cv::Mat_<float> pattern;      ///< linear, 0 to 1; its edges are those of the fields of view
};

/// Returns the value of a projector's picture in a direction, projector's axes and any length:
/// interpolated bilinearly between the centres of its pixels, constant beyond the outermost ones,
/// and 0 outside of the picture.
float pattern_along(const Projector& projector, const Eigen::Vector3d& direction);

/// What an infrared camera sees: a share of the light of the scene, and all that its projectors
/// throw, as one grey value. A surface reflects in it as the mean of its red, green and blue.
struct InfraredBand {
  double scene_light = 1;             ///< share of the scene's light that passes the filter, 0 to 1
  std::vector<Projector> projectors;  ///< drawn by the ray tracer in the modes `direct` and `path`
};

/// Returns an image of linear RGB whose channels are the mean of those of another, times `share`.
cv::Mat_<cv::Vec3f> grey_of(const cv::Mat_<cv::Vec3f>& radiance, double share = 1);

}  // namespace synth
