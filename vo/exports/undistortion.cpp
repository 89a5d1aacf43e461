#include "vo/exports/undistortion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr double kLeastZoom = 0.5;

/// A rectangle of directions (X / Z, Y / Z).
struct DirectionBounds {
  double left = -std::numeric_limits<double>::infinity();
  double right = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
};

/// Returns a rectangle that no part of the image's border enters, so that all of it is imaged. What
/// a fisheye does not image bounds nothing.
DirectionBounds inner_bounds(const PinholeCamera& lens) {
  DirectionBounds bounds;
  const auto direction = [&](int u, int v) { return lens.unproject({u, v}, 1); };
  for (int v = 0; v < lens.height; ++v) {
    bounds.left = std::fmax(bounds.left, direction(0, v).x());
    bounds.right = std::fmin(bounds.right, direction(lens.width - 1, v).x());
  }
  for (int u = 0; u < lens.width; ++u) {
    bounds.top = std::fmax(bounds.top, direction(u, 0).y());
    bounds.bottom = std::fmin(bounds.bottom, direction(u, lens.height - 1).y());
  }
  return bounds;
}

/// Returns the principal point nearest to `centre` from which `pixels` pixels at a focal length lie
/// between two bounds.
double fitted_centre(double centre, double focal, int pixels, double low, double high) {
  const double least = pixels - 1 - high * focal;
  const double greatest = -low * focal;
  return least < greatest ? std::clamp(centre, least, greatest) : (least + greatest) / 2;
}

PinholeCamera straight_camera(const PinholeCamera& lens) {
  const DirectionBounds bounds = inner_bounds(lens);
  require(bounds.left < bounds.right && bounds.top < bounds.bottom,
          "camera: its lens leaves no rectangle to undistort, expected weaker distortion");
  const double zoom =
      std::max({kLeastZoom, (lens.width - 1) / ((bounds.right - bounds.left) * lens.fx),
                (lens.height - 1) / ((bounds.bottom - bounds.top) * lens.fy)});
  PinholeCamera camera = lens.without_distortion();
  camera.fx = zoom * lens.fx;
  camera.fy = zoom * lens.fy;
  camera.cx = fitted_centre(lens.cx, camera.fx, lens.width, bounds.left, bounds.right);
  camera.cy = fitted_centre(lens.cy, camera.fy, lens.height, bounds.top, bounds.bottom);
  return camera;
}

}  // namespace

Undistortion::Undistortion(const PinholeCamera& lens)
    : camera_(straight_camera(lens)),
      origins_(lens.height, lens.width),
      is_hole_(lens.height, lens.width, uchar{0}) {
  for (int v = 0; v < lens.height; ++v) {
    for (int u = 0; u < lens.width; ++u) {
      const Eigen::Vector2d origin = lens.project(camera_.unproject({u, v}, 1));
      origins_(v, u) = {static_cast<float>(origin.x()), static_cast<float>(origin.y())};
      if (!lens.contains(origin)) {
        origins_(v, u) = {0, 0};
        is_hole_(v, u) = 255;
        ++holes_;
      }
    }
  }
}

RgbdFrame Undistortion::apply(const RgbdFrame& frame) const {
  RgbdFrame straight{frame.timestamp, {}, {}, frame.depth_delay};
  cv::remap(frame.image, straight.image, origins_, cv::noArray(), cv::INTER_LINEAR,
            cv::BORDER_REPLICATE);
  straight.image.setTo(0, is_hole_);
  if (!frame.depth.empty()) {
    cv::remap(frame.depth, straight.depth, origins_, cv::noArray(), cv::INTER_NEAREST,
              cv::BORDER_REPLICATE);
    straight.depth.setTo(0, is_hole_);
  }
  return straight;
}

}  // namespace vo
