#include "synth/ray_tracing/multipath_tracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "synth/ray_tracing/depth_sight_tracer.h"
#include "synth/shading/scatter.h"
#include "synth/shading/scrambled_sobol.h"
#include "synth/shading/shading.h"

namespace synth {
namespace {

/// How many times brighter than the straight light one path makes a white diffuse surface at most
/// by a highlight, so that none stands out: those of the lamp on metals, which few paths find, are
/// left out.
constexpr float kBrightest = 10;

constexpr int kBlock = 8;  // px, edge of a square of pixels that share a Sobol sequence

/// Returns the place of a pixel in its square, in Morton order: neighbours that are averaged have
/// parts of the sequence that fill the directions evenly together.
int place_in_block(const cv::Point& pixel) {
  int place = 0;
  for (int bit = 0; 1 << bit < kBlock; ++bit) {
    place |= (pixel.x >> bit & 1) << (2 * bit) | (pixel.y >> bit & 1) << (2 * bit + 1);
  }
  return place;
}

/// Takes the mean of red, green and blue for the base colour in the lamp's light.
void become_grey(SurfacePoint& point) {
  point.base_color.setConstant(point.base_color.mean());
}

Eigen::Vector3f lane_of(const Lanes3& values, std::size_t lane) {
  return {values.x[lane], values.y[lane], values.z[lane]};
}

/// Returns the radiance that a white diffuse surface would send back on the straight path, per
/// intensity of the lamp, 1/(m^2 sr), through what is before it once.
float straight_radiance(const SeenPoint& seen) {
  const float cosine = std::clamp(seen.point.face_normal.dot(seen.point.to_viewer), 0.0F, 1.0F);
  return seen.share * cosine / (std::numbers::pi_v<float> * seen.spread * seen.spread);
}

/// Returns the radiance that a surface reflects of an irradiance of the lamp, its highlight
/// limited: what it reflects more than a white diffuse surface does there counts for at most
/// `most`.
float limited_reflection(float reflected, float irradiance, float most) {
  const float white = irradiance * std::numbers::inv_pi_v<float>;
  return std::min(reflected, white) + std::min(most, std::max(0.0F, reflected - white));
}

}  // namespace

/// A path of light from the lamp to a pixel, followed against its direction.
struct MultipathTracer::Path {
  std::size_t seen = 0;  ///< lane of the point that the pixel sees
  SurfacePoint point;    ///< as seen from the path's surface before, with a grey base colour
  float weight = 1;      ///< radiance at the pixel per radiance that leaves `point` along the path
  float most = 0;    ///< 1/(m^2 sr), greatest radiance of a highlight, per intensity of the lamp
  float length = 0;  ///< m, from the seen point to `point`
  FirstSurface kind = FirstSurface::opaque;
  float share_sent_on = 0;  ///< of the light, by glass
};

struct MultipathTracer::Paths {
  std::size_t size = 0;
  std::array<Path, kPacketSize> lanes;

  void add(const Path& path) { lanes[size++] = path; }
};

MultipathTracer::Phasors MultipathTracer::trace(const SeenPoints& seen) const {
  Phasors sums{};
  for (int sample = 0; sample < options_.samples; ++sample) {
    add_sample(seen, sample, sums);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.size); ++i) {
    sums[i] *= std::numbers::pi * static_cast<double>(seen.lanes[i].share) / options_.samples;
  }
  return sums;
}

/// Adds the phasors, relative to the straight paths, of the light of one path from each pixel.
void MultipathTracer::add_sample(const SeenPoints& seen, int sample, Phasors& sums) const {
  Paths paths;
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.size); ++i) {
    paths.add({.seen = i, .point = seen.lanes[i].point});
    become_grey(paths.lanes[i].point);
  }
  for (int step = 0; step < options_.bounces && paths.size > 0; ++step) {
    paths = next_surfaces(seen, paths, sample, step);
    add_lamp(seen, paths, sums);
  }
}

/// Returns the paths at the next surface that each meets; those that meet none end.
MultipathTracer::Paths MultipathTracer::next_surfaces(const SeenPoints& seen, const Paths& paths,
                                                      int sample, int step) const {
  Paths leaving;
  HitPacket rays;
  for (std::size_t i = 0; i < paths.size; ++i) {
    Path path = paths.lanes[i];
    const cv::Point& pixel = seen.lanes[path.seen].pixel;
    const std::uint64_t bits = random_.bits(pixel.x / kBlock, pixel.y / kBlock, step);
    const CameraRay ray = go_on(bits, place_in_block(pixel) * options_.samples + sample, path);
    if (step == 0) {
      path.most = path.weight * kBrightest * straight_radiance(seen.lanes[path.seen]);
    }
    if (path.weight > 0) {
      leaving.add(path);
      add_ray(rays, ray);
    }
  }
  Paths met;
  if (rays.size > 0) {
    rays.coherence = Coherence::incoherent;
    embree_.intersect(rays, Sight::solid);
  }
  for (int lane = 0; lane < rays.size; ++lane) {
    if (rays.has_hit(lane)) {
      met.add(arrival(leaving.lanes[static_cast<std::size_t>(lane)], rays, lane));
    }
  }
  return met;
}

/// Returns the ray along which a path goes on: straight through glass, otherwise in a direction
/// that the surface scatters from, and weights the path by it. `bits` are random; paths of equal
/// bits have indices of their own.
CameraRay MultipathTracer::go_on(std::uint64_t bits, int index, Path& path) {
  if (path.kind == FirstSurface::glass) {
    path.weight *= path.share_sent_on;
    return ray_from(path.point, -path.point.to_viewer);
  }
  const float lobe = scrambled_sobol(vo::mixed(bits), index).x();
  const Scattered scattered = scatter(path.point, lobe, scrambled_sobol(bits, index));
  path.weight *= scattered.weight.mean();
  return ray_from(path.point, scattered.direction);
}

/// Returns a path where its ray, of unit direction, has met a surface. The maps of materials are
/// blurred over the share of a hemisphere that one sample stands for.
MultipathTracer::Path MultipathTracer::arrival(const Path& leaving, const HitPacket& rays,
                                               int lane) const {
  Path path = leaving;
  const float length = rays.lanes.ray.tfar[lane];
  const float width =
      std::sqrt(2 * std::numbers::pi_v<float> / static_cast<float>(options_.samples));
  const SurfaceTriangle triangle(world_, rays.mesh(lane), rays.triangle(lane), rays.share(lane));
  path.point = surface_point(
      triangle, {rays.weights(lane), rays.direction(lane), width * length, rays.share(lane)});
  become_grey(path.point);
  path.length += length;
  const Material& material = *triangle.mesh->material;
  path.kind = clear_kind(path.point);
  path.share_sent_on = share_sent_on(path.kind, path.point, material, material.ior);
  return path;
}

/// Returns the light of the lamp, of intensity 1, that arrives at each path's surface.
LightLanes MultipathTracer::light_of_lamp(const SeenPoints& seen, const Paths& paths,
                                          const LitLanes& lit) const {
  Lanes3 places;
  std::array<bool, kPacketSize> is_lit{};
  for (std::size_t i = 0; i < paths.size; ++i) {
    const Path& path = paths.lanes[i];
    const int v = seen.lanes[path.seen].pixel.y;
    const Eigen::Vector3f lamp = (view_.position(v) - world_.origin).cast<float>();
    places.x[i] = lamp.x();
    places.y[i] = lamp.y();
    places.z[i] = lamp.z();
    is_lit[i] = path.kind == FirstSurface::opaque && is_in_lamp_field(path.point.position, v);
  }
  const PlacedLight lamp;
  LightLanes light = direct_light(lamp, places, lit, instruction_set_);
  std::transform(is_lit.begin(), is_lit.end(), light.share.begin(), light.share.begin(),
                 [](bool lit_there, float share) { return lit_there ? share : 0; });
  ShadowPacket shadows = shadow_rays(lit);
  shadows.coherence = Coherence::incoherent;
  aim_at_light(shadows, light, shadow_reach(lamp));
  if (shadows.has_rays()) {
    ShadowHit occluder;
    embree_.occlude(shadows, occluder, ShadowCasters::all_but_clear_walls);
    light.keep(shadows.active);
  }
  return light;
}

/// Adds the light of the lamp that each path's surface reflects along it.
void MultipathTracer::add_lamp(const SeenPoints& seen, const Paths& paths, Phasors& sums) const {
  LitLanes lit;
  for (std::size_t i = 0; i < paths.size; ++i) {
    add_point(lit, paths.lanes[i].point);
  }
  const LightLanes light = light_of_lamp(seen, paths, lit);
  Lanes3 reflected;
  add_reflected(lit, light, Eigen::Vector3f::Ones(), instruction_set_, reflected);
  for (std::size_t i = 0; i < paths.size; ++i) {
    const Path& path = paths.lanes[i];
    const float to_lamp = lane_of(light.to_light, i).norm();
    const double detour = path.length + to_lamp - seen.lanes[path.seen].distance;
    const float amplitude = limited_reflection(path.weight * lane_of(reflected, i).mean(),
                                               path.weight * light.share[i], path.most);
    sums[path.seen] += std::polar<double>(amplitude, wave_number_ * detour);
  }
}

bool MultipathTracer::is_in_lamp_field(const Eigen::Vector3f& position, int v) const {
  if (options_.lamp == LampField::all) {
    return true;
  }
  const Eigen::Vector3d p_camera = view_.R_world_camera(v).transpose() *
                                   (position.cast<double>() + world_.origin - view_.position(v));
  return view_.camera().sees(p_camera);
}

}  // namespace synth
