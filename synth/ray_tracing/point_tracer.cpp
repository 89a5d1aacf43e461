#include "synth/ray_tracing/point_tracer.h"

#include <array>
#include <cstddef>

#include "synth/ray_tracing/embree_scene.h"

namespace synth {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;  ///< triangle corners, m, world

/// A ray in world coordinates.
struct Ray {
  Eigen::Vector3d camera_position;
  Eigen::Vector3d direction;   ///< of component 1 along `depth_axis`
  Eigen::Vector3d depth_axis;  ///< unit; the depth of a point counts along it
};

/// Sets the point to where the ray meets the triangle's plane, by Cramer's rule from
///     camera_position + depth direction = a + w1 (b - a) + w2 (c - a).
/// Keeps the point if that is beyond the corners' depths, as ray and plane are nearly parallel.
void refine(const Corners& corners, const Ray& ray, TrianglePoint& point) {
  constexpr double kTolerance = 1e-6;  // relative; the hit was found in single precision
  const Eigen::Vector3d ab = corners[1] - corners[0];
  const Eigen::Vector3d ac = corners[2] - corners[0];
  const Eigen::Vector3d from_a = ray.camera_position - corners[0];
  const Eigen::Vector3d normal = ab.cross(ac);
  const Eigen::Vector3d moment = from_a.cross(ray.direction);
  const double determinant = -normal.dot(ray.direction);
  const double depth = normal.dot(from_a) / determinant;
  Eigen::Vector3d depths;
  for (int i = 0; i < 3; ++i) {
    depths[i] = (corners[i] - ray.camera_position).dot(ray.depth_axis);
  }
  const double margin = kTolerance * depths.cwiseAbs().maxCoeff();
  if (depth >= depths.minCoeff() - margin && depth <= depths.maxCoeff() + margin) {
    const double w1 = ac.dot(moment) / determinant;
    const double w2 = -ab.dot(moment) / determinant;
    point.depth = depth;
    point.weights = {1 - w1 - w2, w1, w2};
  }
}

TrianglePoint point_of(const WorldGeometry& world, const RTCRayHit& hit, const Ray& ray) {
  if (!has_hit(hit)) {
    return {};
  }
  const SurfaceHit surface = surface_hit(hit.hit);
  TrianglePoint point{.mesh = surface.mesh,
                      .triangle = surface.triangle,
                      .weights = surface.weights.cast<double>(),
                      .depth = hit.ray.tfar};
  refine(world_corners(world.meshes[surface.mesh], surface.triangle), ray, point);
  return point;
}

}  // namespace

Eigen::Vector3d position_in(const WorldGeometry& world, const TrianglePoint& point) {
  const Corners corners = world_corners(world.meshes[point.mesh], point.triangle);
  return point.weights[0] * corners[0] + point.weights[1] * corners[1] +
         point.weights[2] * corners[2];
}

Eigen::Vector3d position_in(const WorldGeometry& world, const TrianglePoint& point, float share) {
  const FlatMesh& mesh = world.meshes[point.mesh];
  if (mesh.moments.empty()) {
    return position_in(world, point);
  }
  Eigen::Vector3d position = world.origin;
  const std::array<Eigen::Vector3f, 3> corners = corners_of(mesh, point.triangle, share);
  for (std::size_t i = 0; i < 3; ++i) {
    position += point.weights[static_cast<Eigen::Index>(i)] * corners[i].cast<double>();
  }
  return position;
}

PointTracer::PointTracer(const Scene& scene)
    : world_(flatten(scene)), embree_(std::make_unique<EmbreeScene>(world_)) {}

PointTracer::~PointTracer() = default;

std::vector<TrianglePoint> PointTracer::trace(const vo::CameraModel& camera,
                                              const std::vector<Eigen::Vector3d>& rays,
                                              const vo::SE3& T_world_camera) const {
  const Eigen::Matrix3d R_world_camera = T_world_camera.rotation_matrix();
  const Eigen::Vector3d& camera_position = T_world_camera.translation();
  const Eigen::Vector3f start = (camera_position - world_.origin).cast<float>();
  std::vector<RTCRayHit> hits(rays.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Eigen::Vector3d direction = R_world_camera * rays[i];
    aim_along(hits[i], start, direction.cast<float>());
    if (!direction.allFinite()) {  // outside the lens's view
      hits[i].ray.tfar = 0;
    }
  }
  embree_->intersect(hits);
  std::vector<TrianglePoint> points(rays.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Eigen::Vector3d direction = R_world_camera * rays[i];
    const Eigen::Vector3d axis =
        camera.has_optical_axis() ? Eigen::Vector3d(R_world_camera.col(2)) : direction;
    points[i] = point_of(world_, hits[i], {camera_position, direction, axis});
  }
  return points;
}

PointImage PointTracer::trace(const vo::CameraModel& camera, const vo::SE3& T_world_camera) const {
  camera.validate();
  PointImage image{.size = {camera.width(), camera.height()}, .points = {}};
  std::vector<Eigen::Vector3d> rays(static_cast<std::size_t>(camera.width()));
  for (int v = 0; v < camera.height(); ++v) {
    for (int u = 0; u < camera.width(); ++u) {
      rays[static_cast<std::size_t>(u)] = camera.ray({u, v});
    }
    const std::vector<TrianglePoint> row = trace(camera, rays, T_world_camera);
    image.points.insert(image.points.end(), row.begin(), row.end());
  }
  return image;
}

Eigen::Vector3d PointTracer::position(const TrianglePoint& point) const {
  return position_in(world_, point);
}

Eigen::Vector3d PointTracer::face_normal(const TrianglePoint& point,
                                         const Eigen::Vector3d& camera_position) const {
  const Corners corners = world_corners(world_.meshes[point.mesh], point.triangle);
  const Eigen::Vector3d normal =
      (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  return normal.dot(camera_position - corners[0]) < 0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace synth
