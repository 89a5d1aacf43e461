#include "synth/ray_tracing/occluder.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Geometry>

#include "synth/shading/surface.h"

namespace synth {
namespace {

constexpr float kMargin = 0.01F;     // least barycentric weight of a certain hit
constexpr float kLeastSine = 0.02F;  // least sine of the angle between ray and triangle
constexpr float kLeastWidth = 1000;  // least width of the triangle, in roundings of its coordinates

struct Vector {
  float x;
  float y;
  float z;
};

EDVO_INLINE float dot(const Eigen::Vector3f& a, const Vector& b) {
  return a.x() * b.x + a.y() * b.y + a.z() * b.z;
}

/// Deactivates rays that certainly hit the triangle, by Cramer's rule as in point_tracer.cpp.
EDVO_INLINE void stop_rays(const Wall& wall, const RTCRay16& rays, float reach, LaneMask& active) {
  const float least_sine2 = kLeastSine * kLeastSine * wall.normal.squaredNorm();
  const float clearance2 = wall.clearance * wall.clearance;
  LaneMask left;
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    const Vector d{rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]};
    const Vector from_a{rays.org_x[i] - wall.a.x(), rays.org_y[i] - wall.a.y(),
                        rays.org_z[i] - wall.a.z()};
    const Vector moment{from_a.y * d.z - from_a.z * d.y, from_a.z * d.x - from_a.x * d.z,
                        from_a.x * d.y - from_a.y * d.x};
    const float determinant = -dot(wall.normal, d);
    const float length2 = d.x * d.x + d.y * d.y + d.z * d.z;
    const float per_determinant = 1 / determinant;
    const float t = dot(wall.normal, from_a) * per_determinant;
    const float w1 = dot(wall.ac, moment) * per_determinant;
    const float w2 = -dot(wall.ab, moment) * per_determinant;
    const float inside = std::min(std::min(w1, w2), 1 - w1 - w2) - kMargin;
    const float from_end = std::min(t, reach - t);
    const float clear = from_end * from_end * length2 - clearance2;
    const float steep = determinant * determinant - least_sine2 * length2;
    const float certainty = std::min(std::min(inside, from_end), std::min(clear, steep));
    const int before = active[i];
    left[i] = certainty > 0 ? 0 : before;
  }
  active = left;
}

EDVO_TARGET_AVX2 void stop_rays_avx2(const Wall& wall, const RTCRay16& rays, float reach,
                                     LaneMask& active) {
  stop_rays(wall, rays, reach, active);
}

}  // namespace

Occluder::Occluder(const WorldGeometry& world, const ShadowHit& hit) : hit_(hit) {
  const FlatMesh& mesh = world.meshes[hit.mesh];
  const auto [a, b, c] = corners_of(mesh, hit.triangle);
  wall_.a = a;
  wall_.ab = b - a;
  wall_.ac = c - a;
  wall_.normal = wall_.ab.cross(wall_.ac);
  const float rounding = SurfaceTriangle(world, hit.mesh, hit.triangle).rounding;
  const float longest = std::max({wall_.ab.norm(), wall_.ac.norm(), (wall_.ac - wall_.ab).norm()});
  const bool rests = mesh.moments.empty();
  is_usable_ = rests && wall_.normal.norm() > kLeastWidth * rounding * longest;
  wall_.clearance = rounding / kLeastSine;
}

bool Occluder::is(const ShadowHit& hit) const {
  return hit.mesh == hit_.mesh && hit.triangle == hit_.triangle;
}

bool Occluder::stop(ShadowPacket& packet, float reach, vo::InstructionSet set) const {
  if (is_usable_ && set == vo::InstructionSet::baseline) {
    stop_rays(wall_, packet.lanes, reach, packet.active);
  } else if (is_usable_) {
    stop_rays_avx2(wall_, packet.lanes, reach, packet.active);
  }
  return packet.has_rays();
}

}  // namespace synth
