#include "synth/ray_tracing/embree_scene_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace synth {
namespace {

using Eigen::Vector3f;

struct DistanceQuery {
  const WorldGeometry& world;
  Vector3f point;
};

/// Returns the triangle's point closest to p, by the Voronoi region in which p lies (Ericson,
/// Real-Time Collision Detection, 2005, 5.1.5).
Vector3f closest_point(const Vector3f& p, const std::array<Vector3f, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector3f ab = b - a;
  const Vector3f ac = c - a;
  const float d1 = ab.dot(p - a);
  const float d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) {
    return a;
  }
  const float d3 = ab.dot(p - b);
  const float d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) {
    return b;
  }
  const float d5 = ab.dot(p - c);
  const float d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) {
    return c;
  }
  const float over_c = d1 * d4 - d3 * d2;
  const float over_b = d5 * d2 - d1 * d6;
  const float over_a = d3 * d6 - d5 * d4;
  if (over_c <= 0 && d1 >= 0 && d3 <= 0) {
    return a + d1 / (d1 - d3) * ab;
  }
  if (over_b <= 0 && d2 >= 0 && d6 <= 0) {
    return a + d2 / (d2 - d6) * ac;
  }
  if (over_a <= 0 && d4 >= d3 && d5 >= d6) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const float sum = over_a + over_b + over_c;
  return a + over_b / sum * ab + over_c / sum * ac;
}

/// Shrinks a query's radius to a triangle's distance if that is smaller; returns whether it is.
bool come_nearer(RTCPointQueryFunctionArguments* arguments) {
  const auto& query = *static_cast<const DistanceQuery*>(arguments->userPtr);
  const RTCPointQueryContext& context = *arguments->context;
  const unsigned instance = context.instStackSize > 0 ? context.instID[0] : RTC_INVALID_GEOMETRY_ID;
  const std::array<Vector3f, 3> corners =
      corners_of(query.world.meshes[mesh_of(instance, arguments->geomID)],
                 static_cast<int>(arguments->primID));
  const float distance = (closest_point(query.point, corners) - query.point).norm();
  if (!(distance < arguments->query->radius)) {
    return false;
  }
  arguments->query->radius = distance;
  return true;
}

RTCRayHit ray_along(const Vector3f& from, const Vector3f& direction, float reach) {
  RTCRayHit ray{};
  ray.ray.org_x = from.x();
  ray.ray.org_y = from.y();
  ray.ray.org_z = from.z();
  ray.ray.dir_x = direction.x();
  ray.ray.dir_y = direction.y();
  ray.ray.dir_z = direction.z();
  ray.ray.tfar = reach;
  ray.ray.mask = std::numeric_limits<unsigned>::max();
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

/// Returns whether a ray hit the front by the mesh's own winding, which mirroring reverses.
bool shows_its_front(const WorldGeometry& world, const RTCRayHit& ray) {
  const SurfaceHit hit = surface_hit(ray.hit);
  const FlatMesh& mesh = world.meshes[hit.mesh];
  const auto [a, b, c] = corners_of(mesh, hit.triangle);
  const Vector3f normal = (b - a).cross(c - a);
  const Vector3f direction(ray.ray.dir_x, ray.ray.dir_y, ray.ray.dir_z);
  const bool is_mirrored = mesh.T_world_mesh.linear().determinant() < 0;
  return (normal.dot(direction) < 0) != is_mirrored;
}

}  // namespace

float distance_to_surface(const EmbreeScene& embree, const WorldGeometry& world,
                          const Vector3f& point, float reach) {
  DistanceQuery query{world, point};
  RTCPointQuery sphere{point.x(), point.y(), point.z(), 0, reach};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(embree.hierarchy(), &sphere, &context, come_nearer, &query);
  return sphere.radius;
}

std::vector<ProbeHit> probe(const EmbreeScene& embree, const WorldGeometry& world,
                            const Vector3f& point, const std::vector<Vector3f>& directions) {
  std::vector<RTCRayHit> rays;
  for (const Vector3f& direction : directions) {
    rays.push_back(ray_along(point, direction, std::numeric_limits<float>::infinity()));
  }
  embree.intersect(rays);
  std::vector<ProbeHit> hits;
  for (const RTCRayHit& ray : rays) {
    hits.push_back(has_hit(ray) ? ProbeHit{ray.ray.tfar, shows_its_front(world, ray)} : ProbeHit{});
  }
  return hits;
}

bool is_blocked(const EmbreeScene& embree, const Vector3f& from, const Vector3f& to) {
  std::vector<RTCRay> rays = {ray_along(from, to - from, 1).ray};
  embree.occlude(rays);
  return is_occluded(rays.front());
}

}  // namespace synth
