#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "synth/rendering/triangle_point.h"
#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

class EmbreeScene;

/// Returns a point's position, m, world, in a scene's geometry, even if it was traced in that of
/// another time.
Eigen::Vector3d position_in(const WorldGeometry& world, const TrianglePoint& point);

/// Returns a point's position, m, world, at an instant, `share` being a value of
/// WorldGeometry::share_at; of a mesh that moves, in single precision from the world's origin.
Eigen::Vector3d position_in(const WorldGeometry& world, const TrianglePoint& point, float share);

/// Finds the surface points that a static camera sees of a static scene. Embree finds the triangle
/// in single precision, the rest is double precision. The scene must outlive the tracer.
class PointTracer {
 public:
  explicit PointTracer(const Scene& scene);
  ~PointTracer();
  PointTracer(const PointTracer&) = delete;
  PointTracer& operator=(const PointTracer&) = delete;
  PointTracer(PointTracer&&) = delete;
  PointTracer& operator=(PointTracer&&) = delete;

  PointImage trace(const vo::CameraModel& camera, const vo::SE3& T_world_camera) const;

  /// Returns the first hits of rays from a camera, which are as CameraModel::ray returns them.
  std::vector<TrianglePoint> trace(const vo::CameraModel& camera,
                                   const std::vector<Eigen::Vector3d>& rays,
                                   const vo::SE3& T_world_camera) const;

  /// Returns a point's world position, m, in this scene, even if it was traced at another time.
  Eigen::Vector3d position(const TrianglePoint& point) const;

  /// Returns the unit normal of the point's triangle, world, towards the camera; zero if the
  /// triangle has no area.
  Eigen::Vector3d face_normal(const TrianglePoint& point,
                              const Eigen::Vector3d& camera_position) const;

  const WorldGeometry& scene() const { return world_; }

 private:
  WorldGeometry world_;
  std::unique_ptr<const EmbreeScene> embree_;
};

}  // namespace synth
