#include "synth/embree_scene.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr float kNear = 0.01F;  // m along the optical axis
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Geometry = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

void keep_first_error(void* message, RTCError /*code*/, const char* text) {
  auto& first = *static_cast<std::string*>(message);
  if (first.empty()) {
    first = text;
  }
}

void attach(RTCDevice device, RTCScene hierarchy, const FlatMesh& flat, unsigned index) {
  const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             flat.positions.data(), 0, sizeof(Eigen::Vector3f),
                             flat.mesh->positions.size());
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             flat.mesh->triangles.data(), 0, sizeof(flat.mesh->triangles[0]),
                             flat.mesh->triangles.size());
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(hierarchy, geometry.get(), index);
}

RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

/// `reach` is in lengths of the direction.
void aim(RTCRay& ray, const Eigen::Vector3f& from, const Eigen::Vector3f& direction, float near,
         float reach) {
  ray.org_x = from.x();
  ray.org_y = from.y();
  ray.org_z = from.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = near;
  ray.tfar = reach;
  ray.mask = std::numeric_limits<unsigned>::max();
}

}  // namespace

EmbreeScene::EmbreeScene(const FlatScene& flat) : device_(rtcNewDevice(nullptr)) {
  vo::require(device_ != nullptr, "Embree: no device, error ", rtcGetDeviceError(nullptr));
  std::string error;
  rtcSetDeviceErrorFunction(device_.get(), keep_first_error, &error);
  hierarchy_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(hierarchy_.get(), RTC_SCENE_FLAG_ROBUST);
  for (unsigned i = 0; i < flat.meshes.size(); ++i) {
    attach(device_.get(), hierarchy_.get(), flat.meshes[i], i);
  }
  rtcCommitScene(hierarchy_.get());
  rtcSetDeviceErrorFunction(device_.get(), nullptr, nullptr);
  vo::require(error.empty(), "Embree: ", error);
}

void EmbreeScene::intersect(std::vector<RTCRayHit>& rays) const {
  RTCIntersectContext context = coherent_context();
  rtcIntersect1M(hierarchy_.get(), &context, rays.data(), static_cast<unsigned>(rays.size()),
                 sizeof(RTCRayHit));
}

void EmbreeScene::occlude(std::vector<RTCRay>& rays) const {
  RTCIntersectContext context = coherent_context();
  rtcOccluded1M(hierarchy_.get(), &context, rays.data(), static_cast<unsigned>(rays.size()),
                sizeof(RTCRay));
}

bool has_hit(const RTCRayHit& ray) {
  return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

bool is_occluded(const RTCRay& ray) {
  return ray.tfar < 0;
}

SurfaceHit surface_hit(const RTCHit& hit) {
  return {.mesh = static_cast<int>(hit.geomID),
          .triangle = static_cast<int>(hit.primID),
          .weights = {1 - hit.u - hit.v, hit.u, hit.v}};
}

void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const Light& light) {
  const Eigen::Vector3f start = point.position + point.rounding * point.face_normal;
  aim(ray, start, direct.to_light, 0, light.kind == LightKind::directional ? kInfinity : 1);
}

View::View(const FlatScene& flat, const vo::PinholeCamera& camera, const vo::SE3& T_world_camera)
    : flat_(flat),
      camera_(camera),
      R_world_camera_(T_world_camera.rotation_matrix()),
      eye_(T_world_camera.translation()),
      start_((eye_ - flat.origin).cast<float>()) {}

/// World axes; 1 along the optical axis, so that multiples of it are depths.
Eigen::Vector3d View::direction(const Eigen::Vector2d& pixel) const {
  return R_world_camera_ * camera_.unproject(pixel, 1);
}

void View::aim_through(const Eigen::Vector2d& pixel, RTCRayHit& ray) const {
  aim(ray.ray, start_, direction(pixel).cast<float>(), kNear, kInfinity);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

float View::exact_depth(const Eigen::Vector2d& pixel, const RTCRayHit& ray) const {
  const DepthRay exact{eye_, direction(pixel), R_world_camera_.col(2)};
  const std::optional<double> depth =
      depth_of_plane(flat_.meshes[ray.hit.geomID], static_cast<int>(ray.hit.primID), exact);
  return depth ? static_cast<float>(*depth) : ray.ray.tfar;
}

}  // namespace synth
