#include "synth/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "synth/embree_scene.h"
#include "synth/flat_scene.h"
#include "synth/shading.h"

namespace synth {
namespace {

constexpr int kTile = 8;  // px; the rays of a tile are traced together

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

/// The wanted channels, nothing seen yet.
RenderedFrame empty_frame(const vo::PinholeCamera& camera, const Channels& channels) {
  const cv::Size size(camera.width, camera.height);
  const cv::Vec3f none(0, 0, 0);
  RenderedFrame frame;
  if (channels.color) {
    frame.radiance = cv::Mat_<cv::Vec3f>(size, none);
  }
  if (channels.depth) {
    frame.depth = vo::DepthImage(size, 0.0F);
  }
  if (channels.normal) {
    frame.normal = cv::Mat_<cv::Vec3f>(size, none);
  }
  return frame;
}

class RayTracer final : public Renderer {
 public:
  RayTracer(const Scene& scene, const RenderOptions& options);

  using Renderer::render;
  RenderedFrame render(const Shot& shot) const override;

 private:
  void render_surface(const View& view, const cv::Rect& tile, Samples& samples,
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
  EmbreeScene embree_;
};

RayTracer::RayTracer(const Scene& scene, const RenderOptions& options)
    : flat_(flatten(scene)),
      ambient_(ambient_light(flat_, options.ambient)),
      light_positions_(light_positions(flat_)),
      grid_(options.samples_per_edge()),
      embree_(flat_) {}

RenderedFrame RayTracer::render(const Shot& shot) const {
  const vo::PinholeCamera& camera = shot.camera;
  camera.validate();
  shot.shutter.validate();
  const View view(flat_, shot);
  RenderedFrame frame = empty_frame(camera, shot.channels);
  Samples samples;
  const cv::Rect image(0, 0, camera.width, camera.height);
  for (int v = 0; v < camera.height; v += kTile) {
    for (int u = 0; u < camera.width; u += kTile) {
      const cv::Rect tile = cv::Rect(u, v, kTile, kTile) & image;
      if (shot.channels.depth || shot.channels.normal) {
        render_surface(view, tile, samples, frame);
      }
      if (shot.channels.color) {
        render_color(view, tile, samples, frame);
      }
    }
  }
  return frame;
}

/// Depth and normals.
void RayTracer::render_surface(const View& view, const cv::Rect& tile, Samples& samples,
                               RenderedFrame& frame) const {
  samples.rays.clear();
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u) {
      view.aim_at_centre({u, v}, samples.rays.emplace_back());
    }
  }
  embree_.intersect(samples.rays);
  auto ray = samples.rays.cbegin();
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u, ++ray) {
      if (has_hit(*ray) && !frame.depth.empty()) {
        frame.depth(v, u) = view.exact_depth({u, v}, *ray);
      }
      if (has_hit(*ray) && !frame.normal.empty()) {
        frame.normal(v, u) = view.normal({u, v}, *ray);
      }
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
  for (int v = tile.y; v < tile.br().y; ++v) {
    for (int u = tile.x; u < tile.br().x; ++u) {
      for (int i = 0; i < grid_ * grid_; ++i) {
        view.aim_at_cell({u, v}, {i % grid_, i / grid_}, grid_, samples.rays.emplace_back());
      }
    }
  }
  embree_.intersect(samples.rays);
}

/// Everything but the lights.
void RayTracer::shade(const View& view, Samples& samples) const {
  const vo::PinholeCamera& camera = view.camera();
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
    samples.radiance[i] = point.emission + lambert(point, ambient_.irradiance(point.normal));
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
    aim_at_light(samples.shadow_rays.emplace_back(), point, direct, light);
    Reflection& reflection = samples.reflections.emplace_back();
    reflection.ray = samples.lit_rays[i];
    reflection.radiance = lambert(point, direct.irradiance);
  }
  embree_.occlude(samples.shadow_rays);
  for (std::size_t i = 0; i < samples.reflections.size(); ++i) {
    if (!is_occluded(samples.shadow_rays[i])) {
      samples.radiance[samples.reflections[i].ray] += samples.reflections[i].radiance;
    }
  }
}

}  // namespace

std::unique_ptr<Renderer> make_ray_tracer(const Scene& scene, const RenderOptions& options) {
  return std::make_unique<RayTracer>(scene, options);
}

}  // namespace synth
