#pragma once

#include <Eigen/Core>

#include "vo/geometry/depth_noise.h"
#include "vo/geometry/lens.h"
#include "vo/geometry/readout.h"

namespace vo {

/// Pinhole camera with lens distortion. Frame: x right, y down, z forward. Pixel (0, 0) is the
/// CENTRE of the top-left pixel, so the image spans [-0.5, width - 0.5) x [-0.5, height - 0.5).
/// A negative fy means a frame with y up (ICL-NUIM); nothing here takes its absolute value.
struct PinholeCamera {
  int width = 0;   ///< px, columns of the image
  int height = 0;  ///< px, rows of the image
  double fx = 0;   ///< px, focal length along x
  double fy = 0;   ///< px, focal length along y
  double cx = 0;   ///< px, principal point along x
  double cy = 0;   ///< px, principal point along y
  Distortion distortion;

  /// Returns a camera with square pixels and its principal point at the image centre. Throws Error
  /// unless 0 < fov_deg < 180.
  static PinholeCamera from_horizontal_fov(int width, int height, double fov_deg);

  Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const;  ///< px, needs p_camera.z() > 0

  /// Returns the point at a pixel, m in the camera frame, given its depth along z, m. Not a number
  /// where the lens images nothing.
  Eigen::Vector3d unproject(const Eigen::Vector2d& pixel, double depth) const;
  bool contains(const Eigen::Vector2d& pixel, double border_px = 0) const;

  PinholeCamera halved() const;              ///< the next pyramid level: cx' = (cx + 0.5) / 2 - 0.5
  PinholeCamera without_distortion() const;  ///< these intrinsics with a perfect lens

  void validate() const;  ///< throws Error unless the values are usable
};

template <typename Visitor>
void visit_fields(Visitor& visit, PinholeCamera& camera) {
  visit("width", camera.width, "px");
  visit("height", camera.height, "px");
  visit("fx", camera.fx, "focal length, px");
  visit("fy", camera.fy, "focal length, px; negative where the camera's y axis points up");
  visit("cx", camera.cx, "principal point, px; the centre of the top-left pixel is 0");
  visit("cy", camera.cy, "principal point, px; the centre of the top-left pixel is 0");
  visit("distortion", camera.distortion, "of the lens");
}

/// Throws Error unless a camera can have an image of this size, px.
void require_image_size(int width, int height);

/// A colour camera with a depth image registered to it.
struct RgbdCamera {
  PinholeCamera pinhole;
  double depth_units_per_m = 5000;  ///< a 16-bit depth pixel divided by this is metres
  Readout readout;                  ///< of a rolling shutter; 0 s where it is not known
  DepthNoise depth_noise;           ///< of the depth camera; 0 where it is not known

  void validate() const;  ///< throws Error unless the values are usable
};

/// Visits what an RGB-D camera has beside its projection.
template <typename Visitor, typename Camera>
void visit_depth_fields(Visitor& visit, Camera& camera) {
  visit("depth_units_per_m", camera.depth_units_per_m, "value of a 16-bit depth pixel at 1 m");
  visit(
      "readout", camera.readout.seconds,
      "rolling shutter's time from the first to the last line, s, negative where the last is read "
      "first; 0 is unknown");
  visit("readout_axis", camera.readout.axis, "which lines the shutter reads");
  visit("depth_noise", camera.depth_noise, "of the depth camera; 0 is unknown");
}

template <typename Visitor>
void visit_fields(Visitor& visit, RgbdCamera& camera) {
  visit_fields(visit, camera.pinhole);
  visit_depth_fields(visit, camera);
}

}  // namespace vo
