#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/shading.h"
#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

class EmbreeScene;
class View;

/// The surface at the centre of each pixel, without a sensor's effects. All values are 0 where no
/// surface was hit.
struct SurfaceView {
  vo::DepthImage depth;             ///< m along the optical axis; 0 = no hit
  cv::Mat_<cv::Vec3f> face_normal;  ///< unit, camera's axes, of the triangle, towards the camera
  cv::Mat_<cv::Vec3f> normal;       ///< unit, camera's axes, interpolated, with the normal map
  cv::Mat_<cv::Vec3f> base_color;   ///< linear RGB
  cv::Mat_<float> light_share;      ///< fraction of the unshadowed light that arrives
};

/// Traces one camera ray per pixel, and a shadow ray from its hit to each light.
class SurfaceTracer {
 public:
  /// The scene must outlive the tracer. `ambient` is the value of RenderOptions::ambient.
  SurfaceTracer(const Scene& scene, double ambient);
  ~SurfaceTracer();
  SurfaceTracer(const SurfaceTracer&) = delete;
  SurfaceTracer& operator=(const SurfaceTracer&) = delete;
  SurfaceTracer(SurfaceTracer&&) = delete;
  SurfaceTracer& operator=(SurfaceTracer&&) = delete;

  SurfaceView trace(const vo::CameraModel& camera, const vo::SE3& T_world_camera) const;

  Eigen::AlignedBox3d bounds() const { return visible_bounds(world_); }  ///< m, world
  const WorldGeometry& world() const { return world_; }
  const EmbreeScene& embree() const { return *embree_; }

 private:
  void trace_row(const View& view, int v, SurfaceView& surfaces) const;
  std::vector<float> light_shares(const std::vector<SurfacePoint>& points) const;
  void add_light(const PlacedLight& light, const std::vector<SurfacePoint>& points,
                 std::vector<float>& unshadowed, std::vector<float>& arriving) const;

  WorldGeometry world_;
  AmbientLight ambient_;
  std::vector<PlacedLight> lights_;
  std::unique_ptr<const EmbreeScene> embree_;
};

}  // namespace synth
