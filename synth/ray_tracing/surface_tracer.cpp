#include "synth/ray_tracing/surface_tracer.h"

#include <cstddef>

#include "synth/ray_tracing/embree_scene.h"

namespace synth {
namespace {

cv::Vec3f as_pixel(const Eigen::Vector3f& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

SurfaceView empty_view(const cv::Size& size) {
  const cv::Vec3f none(0, 0, 0);
  return {.depth = vo::DepthImage(size, 0.0F),
          .face_normal = cv::Mat_<cv::Vec3f>(size, none),
          .normal = cv::Mat_<cv::Vec3f>(size, none),
          .base_color = cv::Mat_<cv::Vec3f>(size, none),
          .light_share = cv::Mat_<float>(size, 0.0F)};
}

/// Stores the surface at a pixel, with a light share of 1.
void record(const View& view, const cv::Point& pixel, const RTCRayHit& ray,
            const SurfacePoint& point, SurfaceView& surfaces) {
  const Eigen::Matrix3f R_camera_world = view.R_world_camera(pixel.y).transpose().cast<float>();
  surfaces.depth(pixel) = view.exact_depth(pixel, ray);
  surfaces.face_normal(pixel) = as_pixel(R_camera_world * point.face_normal);
  surfaces.normal(pixel) = as_pixel(R_camera_world * point.normal);
  surfaces.base_color(pixel) = as_pixel(point.base_color);
  surfaces.light_share(pixel) = 1;
}

}  // namespace

SurfaceTracer::SurfaceTracer(const Scene& scene, double ambient)
    : world_(flatten(scene)),
      ambient_(ambient_light(world_, ambient)),
      lights_(place_lights(world_)),
      embree_(std::make_unique<EmbreeScene>(world_)) {}

SurfaceTracer::~SurfaceTracer() = default;

SurfaceView SurfaceTracer::trace(const vo::CameraModel& camera,
                                 const vo::SE3& T_world_camera) const {
  camera.validate();
  const Capture capture = still(camera, T_world_camera);
  const View view(world_, capture);
  SurfaceView surfaces = empty_view({camera.width(), camera.height()});
  for (int v = 0; v < camera.height(); ++v) {
    trace_row(view, v, surfaces);
  }
  return surfaces;
}

void SurfaceTracer::trace_row(const View& view, int v, SurfaceView& surfaces) const {
  const int width = view.camera().width();
  std::vector<RTCRayHit> rays(static_cast<std::size_t>(width));
  for (int u = 0; u < width; ++u) {
    view.aim_at_centre({u, v}, rays[static_cast<std::size_t>(u)]);
  }
  embree_->intersect(rays);
  std::vector<SurfacePoint> lit;
  std::vector<int> lit_columns;
  for (int u = 0; u < width; ++u) {
    const auto& [ray, hit] = rays[static_cast<std::size_t>(u)];
    if (!has_hit({ray, hit})) {
      continue;
    }
    const SurfaceHit seen = surface_hit(hit);
    const SurfacePoint point = surface_point(world_, seen, {ray.dir_x, ray.dir_y, ray.dir_z},
                                             view.pixel_width() * ray.tfar);
    record(view, {u, v}, {ray, hit}, point, surfaces);
    if (!world_.meshes[seen.mesh].material->unlit) {
      lit.push_back(point);
      lit_columns.push_back(u);
    }
  }
  const std::vector<float> shares = light_shares(lit);
  for (std::size_t i = 0; i < lit.size(); ++i) {
    surfaces.light_share(v, lit_columns[i]) = shares[i];
  }
}

std::vector<float> SurfaceTracer::light_shares(const std::vector<SurfacePoint>& points) const {
  std::vector<float> arriving(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    arriving[i] = ambient_.irradiance(points[i].normal).sum();
  }
  std::vector<float> unshadowed = arriving;
  for (const PlacedLight& light : lights_) {
    add_light(light, points, unshadowed, arriving);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    arriving[i] = unshadowed[i] > 0 ? arriving[i] / unshadowed[i] : 1;
  }
  return arriving;
}

void SurfaceTracer::add_light(const PlacedLight& light, const std::vector<SurfacePoint>& points,
                              std::vector<float>& unshadowed, std::vector<float>& arriving) const {
  std::vector<RTCRay> rays(points.size());
  std::vector<float> direct(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DirectLight reach = direct_light(light, points[i]);
    direct[i] = reach.irradiance.sum();
    aim_at_light(rays[i], points[i], reach, light);
  }
  embree_->occlude(rays);
  for (std::size_t i = 0; i < points.size(); ++i) {
    unshadowed[i] += direct[i];
    arriving[i] += is_occluded(rays[i]) ? 0 : direct[i];
  }
}

}  // namespace synth
