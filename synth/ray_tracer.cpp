#include "synth/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <embree3/rtcore.h>

#include "synth/flat_scene.h"
#include "synth/shading.h"
#include "vo/core/error.h"

namespace synth {
namespace {

constexpr float kNear = 0.01F;  // m along the optical axis
constexpr int kTile = 8;        // px; the rays of a tile are traced together
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using BoundingHierarchy = std::unique_ptr<RTCSceneTy, Release>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release>;

void keep_first_error(void* message, RTCError /*code*/, const char* text) {
  auto& first = *static_cast<std::string*>(message);
  if (first.empty()) {
    first = text;
  }
}

Device make_device() {
  Device device(rtcNewDevice(nullptr));
  vo::require(device != nullptr, "Embree: no device, error ", rtcGetDeviceError(nullptr));
  return device;
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

BoundingHierarchy build_hierarchy(RTCDevice device, const FlatScene& flat) {
  std::string error;
  rtcSetDeviceErrorFunction(device, keep_first_error, &error);
  BoundingHierarchy hierarchy(rtcNewScene(device));
  rtcSetSceneFlags(hierarchy.get(), RTC_SCENE_FLAG_ROBUST);
  for (unsigned i = 0; i < flat.meshes.size(); ++i) {
    attach(device, hierarchy.get(), flat.meshes[i], i);
  }
  rtcCommitScene(hierarchy.get());
  rtcSetDeviceErrorFunction(device, nullptr, nullptr);
  vo::require(error.empty(), "Embree: ", error);
  return hierarchy;
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

bool has_hit(const RTCRayHit& ray) {
  return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

SurfaceHit surface_hit(const RTCHit& hit) {
  return {.mesh = static_cast<int>(hit.geomID),
          .triangle = static_cast<int>(hit.primID),
          .weights = {1 - hit.u - hit.v, hit.u, hit.v}};
}

struct View {
  const vo::PinholeCamera& camera;
  Eigen::Matrix3d R_world_camera;
  Eigen::Vector3d eye;    ///< m, world
  Eigen::Vector3f start;  ///< m, the eye in the flat scene's coordinates

  /// World axes; 1 along the optical axis, so that multiples of it are depths.
  Eigen::Vector3d direction(const Eigen::Vector2d& pixel) const {
    return R_world_camera * camera.unproject(pixel, 1);
  }

  void aim_through(const Eigen::Vector2d& pixel, RTCRayHit& ray) const {
    aim(ray.ray, start, direction(pixel).cast<float>(), kNear, kInfinity);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  }
};

/// Of the triangle's plane; the ray's own where that makes no sense.
float exact_depth(const FlatScene& flat, const View& view, const RTCRayHit& ray,
                  const Eigen::Vector3d& direction) {
  const DepthRay exact{view.eye, direction, view.R_world_camera.col(2)};
  const std::optional<double> depth =
      depth_of_plane(flat.meshes[ray.hit.geomID], static_cast<int>(ray.hit.primID), exact);
  return depth ? static_cast<float>(*depth) : ray.ray.tfar;
}

/// Light on its way back along a ray, if nothing shadows it.
struct Reflection {
  std::size_t ray = 0;
  Eigen::Vector3f radiance = Eigen::Vector3f::Zero();
};

/// The samples of one tile, reused from tile to tile.
struct Samples {
  std::vector<RTCRayHit> rays;
  std::vector<Eigen::Vector3f> radiance;  ///< linear RGB, one per ray
  std::vector<SurfacePoint> lit;          ///< hits that light changes
  std::vector<std::size_t> lit_rays;      ///< the ray of each
  std::vector<RTCRay> shadow_rays;        ///< towards one light
  std::vector<Reflection> reflections;    ///< one per shadow ray
};

class RayTracer final : public Renderer {
 public:
  RayTracer(const Scene& scene, const RenderOptions& options);

  RenderedFrame render(const vo::PinholeCamera& camera,
                       const vo::SE3& T_world_camera) const override;

 private:
  void trace(std::vector<RTCRayHit>& rays) const;
  void render_depth(const View& view, const cv::Rect& tile, Samples& samples,
                    RenderedFrame& frame) const;
  void render_color(const View& view, const cv::Rect& tile, Samples& samples,
                    RenderedFrame& frame) const;
  void trace_color_rays(const View& view, const cv::Rect& tile, Samples& samples) const;
  void shade(const View& view, Samples& samples) const;
  void add_light(std::size_t light_index, Samples& samples) const;

  FlatScene flat_;
  AmbientLight ambient_;
  std::vector<Eigen::Vector3f> light_positions_;  ///< m, in the flat scene's coordinates
  int grid_;                                      ///< colour samples along a pixel's edge
  Device device_;
  BoundingHierarchy hierarchy_;
};

RayTracer::RayTracer(const Scene& scene, const RenderOptions& options)
    : flat_(flatten(scene)),
      ambient_(ambient_light(flat_, options.ambient)),
      grid_(options.samples_per_edge()),
      device_(make_device()),
      hierarchy_(build_hierarchy(device_.get(), flat_)) {
  for (const Light& light : scene.lights) {
    light_positions_.emplace_back((light.position - flat_.origin).cast<float>());
  }
}

RenderedFrame RayTracer::render(const vo::PinholeCamera& camera,
                                const vo::SE3& T_world_camera) const {
  camera.validate();
  const Eigen::Vector3d& eye = T_world_camera.translation();
  const View view{.camera = camera,
                  .R_world_camera = T_world_camera.rotation_matrix(),
                  .eye = eye,
                  .start = (eye - flat_.origin).cast<float>()};
  RenderedFrame frame{.radiance = cv::Mat_<cv::Vec3f>(camera.height, camera.width),
                      .depth = vo::DepthImage(camera.height, camera.width)};
  Samples samples;
  const cv::Rect image(0, 0, camera.width, camera.height);
  for (int v = 0; v < camera.height; v += kTile) {
    for (int u = 0; u < camera.width; u += kTile) {
      const cv::Rect tile = cv::Rect(u, v, kTile, kTile) & image;
      render_depth(view, tile, samples, frame);
      render_color(view, tile, samples, frame);
    }
  }
  return frame;
}

void RayTracer::trace(std::vector<RTCRayHit>& rays) const {
  RTCIntersectContext context = coherent_context();
  rtcIntersect1M(hierarchy_.get(), &context, rays.data(), static_cast<unsigned>(rays.size()),
                 sizeof(RTCRayHit));
}

void RayTracer::render_depth(const View& view, const cv::Rect& tile, Samples& samples,
                             RenderedFrame& frame) const {
  samples.rays.clear();
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u) {
      view.aim_through({u, v}, samples.rays.emplace_back());
    }
  }
  trace(samples.rays);
  auto ray = samples.rays.cbegin();
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u, ++ray) {
      frame.depth(v, u) =
          has_hit(*ray) ? exact_depth(flat_, view, *ray, view.direction({u, v})) : 0;
    }
  }
}

void RayTracer::render_color(const View& view, const cv::Rect& tile, Samples& samples,
                             RenderedFrame& frame) const {
  trace_color_rays(view, tile, samples);
  shade(view, samples);
  for (std::size_t i = 0; i < light_positions_.size(); ++i) {
    add_light(i, samples);
  }
  const int per_pixel = grid_ * grid_;
  auto sample = samples.radiance.cbegin();
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int i = 0; i < per_pixel; ++i, ++sample) {
        sum += *sample;
      }
      sum /= static_cast<float>(per_pixel);
      frame.radiance(v, u) = {sum.x(), sum.y(), sum.z()};
    }
  }
}

/// Pixel by pixel, the centres of the pixel's grid of sub-pixels.
void RayTracer::trace_color_rays(const View& view, const cv::Rect& tile, Samples& samples) const {
  samples.rays.clear();
  const auto centre = [this](int i) { return (i + 0.5) / grid_ - 0.5; };
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u) {
      for (int i = 0; i < grid_ * grid_; ++i) {
        view.aim_through({u + centre(i % grid_), v + centre(i / grid_)},
                         samples.rays.emplace_back());
      }
    }
  }
  trace(samples.rays);
}

/// Everything but the lights.
void RayTracer::shade(const View& view, Samples& samples) const {
  const vo::PinholeCamera& camera = view.camera;
  const auto sample_width =
      static_cast<float>(1 / (grid_ * std::sqrt(std::abs(camera.fx * camera.fy))));  // at 1 m
  samples.radiance.assign(samples.rays.size(), Eigen::Vector3f::Zero());
  samples.lit.clear();
  samples.lit_rays.clear();
  for (std::size_t i = 0; i < samples.rays.size(); ++i) {
    if (!has_hit(samples.rays[i])) {
      continue;
    }
    const auto& [ray, hit] = samples.rays[i];
    const SurfacePoint point = surface_point(
        flat_, surface_hit(hit), {ray.dir_x, ray.dir_y, ray.dir_z}, sample_width * ray.tfar);
    const Material& material = *flat_.meshes[hit.geomID].material;
    if (material.unlit) {
      samples.radiance[i] = point.base_color;
      continue;
    }
    samples.radiance[i] = material.emission + lambert(point, ambient_.irradiance(point.normal));
    samples.lit.push_back(point);
    samples.lit_rays.push_back(i);
  }
}

void RayTracer::add_light(std::size_t light_index, Samples& samples) const {
  const Light& light = flat_.scene->lights[light_index];
  samples.shadow_rays.clear();
  samples.reflections.clear();
  for (std::size_t i = 0; i < samples.lit.size(); ++i) {
    const SurfacePoint& point = samples.lit[i];
    const DirectLight direct = direct_light(light, light_positions_[light_index], point);
    if (direct.irradiance.isZero(0)) {
      continue;
    }
    const Eigen::Vector3f start = point.position + point.rounding * point.face_normal;
    aim(samples.shadow_rays.emplace_back(), start, direct.to_light, 0,
        light.kind == LightKind::point ? 1 : kInfinity);
    Reflection& reflection = samples.reflections.emplace_back();
    reflection.ray = samples.lit_rays[i];
    reflection.radiance = lambert(point, direct.irradiance);
  }
  RTCIntersectContext context = coherent_context();
  rtcOccluded1M(hierarchy_.get(), &context, samples.shadow_rays.data(),
                static_cast<unsigned>(samples.shadow_rays.size()), sizeof(RTCRay));
  for (std::size_t i = 0; i < samples.reflections.size(); ++i) {
    const bool is_occluded = samples.shadow_rays[i].tfar < 0;
    if (!is_occluded) {
      samples.radiance[samples.reflections[i].ray] += samples.reflections[i].radiance;
    }
  }
}

}  // namespace

std::unique_ptr<Renderer> make_ray_tracer(const Scene& scene, const RenderOptions& options) {
  return std::make_unique<RayTracer>(scene, options);
}

}  // namespace synth
