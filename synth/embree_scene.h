#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <embree3/rtcore.h>
#include <opencv2/core.hpp>

#include "synth/flat_scene.h"
#include "synth/random.h"
#include "synth/shading.h"
#include "synth/shot.h"
#include "vo/core/camera.h"

namespace synth {

/// Finds what rays hit. The flat scene must outlive it.
class EmbreeScene {
 public:
  explicit EmbreeScene(const FlatScene& flat);

  /// The nearest hit of each ray. Faster when neighbours in the list go nearly the same way.
  void intersect(std::vector<RTCRayHit>& rays) const;

  /// Whether each ray hits anything: see `is_occluded`.
  void occlude(std::vector<RTCRay>& rays) const;

  RTCScene hierarchy() const { return hierarchy_.get(); }

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> hierarchy_;
};

bool has_hit(const RTCRayHit& ray);
bool is_occluded(const RTCRay& ray);  ///< after `occlude`
SurfaceHit surface_hit(const RTCHit& hit);

/// A ray from a point of the flat scene along a direction that is 1 along the optical axis.
void aim_along(RTCRayHit& ray, const Eigen::Vector3f& from, const Eigen::Vector3f& direction);

/// A ray from a surface point to the light that `direct` is about.
void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const Light& light);

/// A shot of a flat scene. Both must outlive it.
class View {
 public:
  View(const FlatScene& flat, const Shot& shot);

  const vo::PinholeCamera& camera() const { return shot_.camera; }
  Eigen::Matrix3d R_world_camera(int v) const { return eyes_.of_row(v).R_world_camera; }

  /// Through a pixel's centre in the middle of its exposure.
  void aim_at_centre(const cv::Point& pixel, RTCRayHit& ray) const;

  /// Through the centre of one of the pixel's grid x grid cells, at an instant of its exposure that
  /// is the cell's own: they are spread evenly over it, along rows and columns too.
  void aim_at_cell(const cv::Point& pixel, const cv::Point& cell, int grid, RTCRayHit& ray) const;

  /// Depth, m, at which the ray through the pixel's centre meets the plane of the triangle that
  /// `ray` hit; the ray's own where that makes no sense.
  float exact_depth(const cv::Point& pixel, const RTCRayHit& ray) const;

  /// Unit, camera's axes, of the triangle that the ray through the pixel's centre hit, towards the
  /// camera.
  cv::Vec3f normal(const cv::Point& pixel, const RTCRayHit& ray) const;

 private:
  void aim_from(const Eye& eye, const Eigen::Vector2d& pixel, RTCRayHit& ray) const;

  const FlatScene& flat_;
  const Shot& shot_;
  ShotEyes eyes_;
  RandomField instants_;  ///< where each pixel's instants start, share of the exposure
};

}  // namespace synth
