#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace synth {

class EmbreeScene;

/// A point of a triangle, which moves with it.
struct TrianglePoint {
  int mesh = kNone;      ///< of WorldGeometry::meshes; kNone = nothing hit
  int triangle = kNone;  ///< of that mesh
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< of the triangle's vertices, sum 1
  double depth = 0;                                   ///< m along the optical axis

  bool exists() const { return mesh != kNone; }
};

/// What the centre of each pixel sees, row by row.
struct PointImage {
  cv::Size size;
  std::vector<TrianglePoint> points;

  const TrianglePoint& at(int u, int v) const {
    return points[static_cast<std::size_t>(v) * static_cast<std::size_t>(size.width) +
                  static_cast<std::size_t>(u)];
  }
};

/// Finds what a camera at rest sees of a scene at rest. The ray tracer finds the triangle, the rest
/// is double precision. The scene must outlive it.
class PointTracer {
 public:
  explicit PointTracer(const Scene& scene);
  ~PointTracer();
  PointTracer(const PointTracer&) = delete;
  PointTracer& operator=(const PointTracer&) = delete;
  PointTracer(PointTracer&&) = delete;
  PointTracer& operator=(PointTracer&&) = delete;

  PointImage trace(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera) const;

  /// What rays from a camera hit first. The directions are the camera's axes, 1 along its optical
  /// axis.
  std::vector<TrianglePoint> trace(const std::vector<Eigen::Vector3d>& directions,
                                   const vo::SE3& T_world_camera) const;

  /// m, world; of this scene or of the same at another time.
  Eigen::Vector3d position(const TrianglePoint& point) const;

  /// Of the triangle, world, towards the viewer; zero where it has no area.
  Eigen::Vector3d face_normal(const TrianglePoint& point,
                              const Eigen::Vector3d& camera_position) const;

  const WorldGeometry& scene() const { return world_; }

 private:
  WorldGeometry world_;
  std::unique_ptr<const EmbreeScene> embree_;
};

}  // namespace synth
