#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <embree3/rtcore.h>

#include "synth/flat_scene.h"
#include "synth/shading.h"
#include "vo/core/camera.h"
#include "vo/core/se3.h"

namespace synth {

/// Finds what rays hit. The flat scene must outlive it.
class EmbreeScene {
 public:
  explicit EmbreeScene(const FlatScene& flat);

  /// The nearest hit of each ray. Faster when neighbours in the list go nearly the same way.
  void intersect(std::vector<RTCRayHit>& rays) const;

  /// Whether each ray hits anything: see `is_occluded`.
  void occlude(std::vector<RTCRay>& rays) const;

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

/// A ray from a surface point to the light that `direct` is about.
void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const Light& light);

/// A camera in a flat scene. Both must outlive it.
class View {
 public:
  View(const FlatScene& flat, const vo::PinholeCamera& camera, const vo::SE3& T_world_camera);

  const vo::PinholeCamera& camera() const { return camera_; }
  const Eigen::Matrix3d& rotation() const { return R_world_camera_; }  ///< R_world_camera

  void aim_through(const Eigen::Vector2d& pixel, RTCRayHit& ray) const;

  /// Depth, m, at which the pixel's ray meets the plane of the triangle that `ray` hit; the ray's
  /// own where that makes no sense.
  float exact_depth(const Eigen::Vector2d& pixel, const RTCRayHit& ray) const;

 private:
  Eigen::Vector3d direction(const Eigen::Vector2d& pixel) const;

  const FlatScene& flat_;
  const vo::PinholeCamera& camera_;
  Eigen::Matrix3d R_world_camera_;
  Eigen::Vector3d eye_;    ///< m, world
  Eigen::Vector3f start_;  ///< m, the eye in the flat scene's coordinates
};

}  // namespace synth
