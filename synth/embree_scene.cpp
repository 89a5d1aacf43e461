#include "synth/embree_scene.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr float kNear = 0.01F;  // m along the optical axis
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint64_t kInstants = 0x1257;  // the purpose of their random numbers

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

/// World axes; 1 along the optical axis, so that multiples of it are depths.
Eigen::Vector3d direction(const vo::PinholeCamera& camera, const Eye& eye,
                          const Eigen::Vector2d& pixel) {
  return eye.R_world_camera * camera.unproject(pixel, 1);
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

void aim_along(RTCRayHit& ray, const Eigen::Vector3f& from, const Eigen::Vector3f& direction) {
  aim(ray.ray, from, direction, kNear, kInfinity);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const Light& light) {
  const Eigen::Vector3f start = point.position + point.rounding * point.face_normal;
  aim(ray, start, direct.to_light, 0, light.kind == LightKind::directional ? kInfinity : 1);
}

View::View(const FlatScene& flat, const Shot& shot)
    : flat_(flat), shot_(shot), eyes_(shot), instants_(shot.seed, kInstants, 0) {}

void View::aim_from(const Eye& eye, const Eigen::Vector2d& pixel, RTCRayHit& ray) const {
  aim(ray.ray, (eye.position - flat_.origin).cast<float>(),
      direction(shot_.camera, eye, pixel).cast<float>(), kNear, kInfinity);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

void View::aim_at_centre(const cv::Point& pixel, RTCRayHit& ray) const {
  aim_from(eyes_.of_row(pixel.y), {pixel.x, pixel.y}, ray);
}

/// The instants' differences are the terms of Roberts' R2 sequence.
void View::aim_at_cell(const cv::Point& pixel, const cv::Point& cell, int grid,
                       RTCRayHit& ray) const {
  const Eigen::Vector2d place(pixel.x + (cell.x + 0.5) / grid - 0.5,
                              pixel.y + (cell.y + 0.5) / grid - 0.5);
  if (shot_.shutter.exposure_time == 0) {
    aim_from(eyes_.of_row(pixel.y), place, ray);
    return;
  }
  constexpr double kPlastic = 1.32471795724474602596;  // x^3 = x + 1
  const double share =
      instants_.uniform(pixel.x, pixel.y) + cell.x / kPlastic + cell.y / (kPlastic * kPlastic);
  aim_from(eyes_.during_row(pixel.y, share - std::floor(share)), place, ray);
}

float View::exact_depth(const cv::Point& pixel, const RTCRayHit& ray) const {
  const Eye& eye = eyes_.of_row(pixel.y);
  const DepthRay exact{eye.position,
                       direction(shot_.camera, eye, Eigen::Vector2d(pixel.x, pixel.y)),
                       eye.R_world_camera.col(2)};
  const std::optional<double> depth =
      depth_of_plane(flat_.meshes[ray.hit.geomID], static_cast<int>(ray.hit.primID), exact);
  return depth ? static_cast<float>(*depth) : ray.ray.tfar;
}

cv::Vec3f View::normal(const cv::Point& pixel, const RTCRayHit& ray) const {
  const Eigen::Vector3f across(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
  const Eigen::Vector3f along(ray.ray.dir_x, ray.ray.dir_y, ray.ray.dir_z);
  const Eigen::Vector3f outward = across.dot(along) > 0 ? Eigen::Vector3f(-across) : across;
  const Eigen::Vector3f unit =
      R_world_camera(pixel.y).transpose().cast<float>() * outward.normalized();
  return {unit.x(), unit.y(), unit.z()};
}

}  // namespace synth
