#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

class EmbreeScene;

/// A point of a triangle in barycentric coordinates, so that it moves with the triangle.
struct TrianglePoint {
  int mesh = kNone;      ///< index into WorldGeometry::meshes; kNone = no hit
  int triangle = kNone;  ///< index into Mesh::triangles
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< barycentric, sum 1
  double depth = 0;                                   ///< m, CameraModel::depth

  bool exists() const { return mesh != kNone; }
};

/// The surface points seen at the pixels' centres, row by row.
struct PointImage {
  cv::Size size;
  std::vector<TrianglePoint> points;

  const TrianglePoint& at(int u, int v) const {
    return points[static_cast<std::size_t>(v) * static_cast<std::size_t>(size.width) +
                  static_cast<std::size_t>(u)];
  }
};

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
