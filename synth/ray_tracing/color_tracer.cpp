#include "synth/ray_tracing/color_tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synth/ray_tracing/color_tracer_step.h"
#include "synth/shading/glass.h"
#include "synth/shading/layers.h"
#include "synth/shading/scatter.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr int kMaxLayers = 32;  // blended surfaces along a path; what lies behind them is black
constexpr std::uint64_t kPaths = 0x9a75;  // purpose of the random numbers in mode `path`

}  // namespace

ColorTracer::ColorTracer(const WorldGeometry& world, const EmbreeScene& embree,
                         const RenderOptions& options)
    : world_(world),
      embree_(embree),
      mode_(options.mode),
      bounces_(options.bounces),
      light_radius_(static_cast<float>(options.light_radius)),
      anisotropy_(options.anisotropy),
      ambient_(ambient_light(world, options.ambient)),
      lights_(place_lights(world)),
      environment_(world.scene->environment) {
  if (mode_ == RenderMode::path) {
    has_clear_walls_ =
        std::any_of(world.meshes.begin(), world.meshes.end(),
                    [](const FlatMesh& mesh) { return is_clear_wall(*mesh.material); });
    if (Emitters emitters(world); !emitters.empty()) {
      emitters_.emplace(std::move(emitters));
    }
    if (!environment_.empty()) {
      environment_directions_.emplace(environment_);
    }
  }
}

ColorMemory ColorTracer::new_memory(const Capture& capture) const {
  const std::size_t projectors = capture.infrared ? capture.infrared->projectors.size() : 0;
  return {.seen = {},
          .blockers = std::vector<Occluder>(lights_.size() + 2),
          .projector_blockers = std::vector<Occluder>(projectors)};
}

PacketColors ColorTracer::trace(ColorPacket& packet, ColorMemory& memory,
                                PacketSights* sights) const {
  PacketColors colors;
  colors.fill(Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    packet.start.legs[i] = {i, Eigen::Vector3f::Ones(), 0, 0};
  }
  Step step(packet, memory, colors, sights);
  if (mode_ == RenderMode::path) {
    const vo::RandomField field(packet.seed, kPaths, 0);
    std::transform(packet.ids.begin(), packet.ids.begin() + packet.start.rays.size,
                   step.bits.begin(),
                   [&](const SampleId& id) { return field.bits(id.pixel.x, id.pixel.y, id.half); });
  }
  advance(packet.start, step);
  while (step.next.rays.size > 0 && step.index < bounces_ + kMaxLayers) {
    PathLegs legs = step.next;
    step.next.rays.size = 0;
    step.lit.points.size = 0;
    ++step.index;
    advance(legs, step);
  }
  return colors;
}

void ColorTracer::advance(PathLegs& bundle, Step& step) const {
  bundle.rays.coherence = step.coherence();
  embree_.intersect(bundle.rays, Sight::layers);
  for (int lane = 0; lane < bundle.rays.size; ++lane) {
    if (bundle.rays.has_hit(lane)) {
      meet_surface(bundle, lane, step);
    } else {
      end_leg(bundle, lane, step);
    }
  }
  if (step.lit.points.size > 0) {
    add_lights(step);
    if (step.packet.infrared != nullptr) {
      add_projectors(step);
    }
  }
  if (step.lit.points.size > 0 && emitters_) {
    add_emitters(step);
  }
  if (step.lit.points.size > 0 && environment_directions_) {
    add_environment(step);
  }
}

void ColorTracer::end_leg(const PathLegs& bundle, int lane, Step& step) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  show(weight_at_end(bundle, lane, leg.medium)
           .cwiseProduct(light_from_afar(leg, bundle.rays.direction(lane))),
       leg, step);
}

/// Returns what a leg that hits nothing brings: of an environment its radiance, weighted if
/// `add_environment` draws beside its direction; otherwise a camera ray sees black, a reflected ray
/// the ambient radiance.
Eigen::Vector3f ColorTracer::light_from_afar(const PathLeg& leg,
                                             const Eigen::Vector3f& direction) const {
  if (!environment_.empty()) {
    const Eigen::Vector3f unit = direction.normalized();
    const float weight =
        leg.density == 0 ? 1 : sample_weight(leg.density, environment_directions_->density(unit));
    return weight * environment_.radiance(unit);
  }
  return leg.bounces == 0 ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : ambient_.radiance(direction);
}

/// Returns the ray of a lane where it hits a surface, `reach` m of way from the camera. Its cone
/// has sides as long as it is the camera's own.
SurfaceRay ColorTracer::surface_ray(const PathLegs& bundle, int lane, float reach,
                                    const Step& step) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  const bool has_sides = step.packet.has_sides && leg.is_straight;
  return {bundle.rays.weights(lane),
          bundle.rays.direction(lane),
          step.packet.sample_width * reach,
          bundle.rays.share(lane),
          anisotropy_,
          has_sides ? &step.packet.sides[leg.sample] : nullptr};
}

void ColorTracer::meet_surface(const PathLegs& bundle, int lane, Step& step) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  const FlatMesh& mesh = world_.meshes[static_cast<std::size_t>(bundle.rays.mesh(lane))];
  const Material& material = *mesh.material;
  const bool is_lit = !material.unlit && mode_ != RenderMode::unlit;
  const auto make = [&](int mesh_index, int triangle_index) {
    return SurfaceTriangle(world_, mesh_index, triangle_index, bundle.rays.share(lane),
                           is_lit ? SurfaceMaps::all : SurfaceMaps::color);
  };
  if (!mesh.moments.empty()) {
    step.memory.seen = {};
  }
  const SurfaceTriangle& triangle =
      step.memory.seen.get(bundle.rays.mesh(lane), bundle.rays.triangle(lane), make);
  if (is_lit) {
    meet_lit_surface(bundle, lane, triangle, step);
    return;
  }
  const float reach = leg.travelled + bundle.rays.lanes.ray.tfar[lane];
  const Eigen::Vector4f color = surface_color(triangle, surface_ray(bundle, lane, reach, step));
  const float share = coverage(material, color.w(), leg, step);
  const Eigen::Vector3f weight = weight_at_end(bundle, lane, leg.medium);
  show(share * weight.cwiseProduct(color.head<3>()), leg, step);
  pass(bundle, lane, share, step);
}

void ColorTracer::meet_lit_surface(const PathLegs& bundle, int lane,
                                   const SurfaceTriangle& triangle, Step& step) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  const Material& material = *triangle.mesh->material;
  const float reach = leg.travelled + bundle.rays.lanes.ray.tfar[lane];
  const SurfacePoint point = surface_point(triangle, surface_ray(bundle, lane, reach, step));
  const float share = coverage(material, point.alpha, leg, step);
  pass(bundle, lane, share, step);
  if (share == 0) {
    return;
  }
  const Material* const medium = medium_before(leg, material, point.is_from_behind);
  const Eigen::Vector3f weight = share * weight_at_end(bundle, lane, medium);
  Eigen::Vector3f radiance = weight_of_emission(bundle, lane, triangle, point) * point.emission;
  if (mode_ == RenderMode::direct) {
    radiance += reflect_ambient(point, ambient_);
  } else {
    radiance *= 1 - coat_reflectance(point.clearcoat, point.face_normal.dot(point.to_viewer));
  }
  show(weight.cwiseProduct(radiance), leg, step);
  if (FirstSight* sight = step.sight_of(leg)) {
    const float covered = weight.x();  // the same in all channels before a reflection
    sight->reflectance += covered * point.base_color;
    sight->reflectance +=
        covered * point.normal_reflectance * (1 - point.metallic) * point.specular;
    sight->normal += covered * point.normal;
    sight->nearness += covered / reach;
  }
  scatter_from({leg, material, medium, point, weight, reach}, step);
}

/// Adds the radiance of the scene that a leg sees at its end, which is without noise as long as the
/// leg comes straight from the camera.
void ColorTracer::show(const Eigen::Vector3f& radiance, const PathLeg& leg, Step& step) {
  const Eigen::Vector3f seen = step.packet.scene_light() * radiance;
  step.colors[leg.sample] += seen;
  if (FirstSight* sight = step.sight_of(leg)) {
    sight->shown += seen;
  }
}

/// Lights the surface that a leg meets and continues the path.
void ColorTracer::scatter_from(Arrival arrival, Step& step) const {
  if (mode_ == RenderMode::path && arrival.material.layers.any() && meet_layer(arrival, step)) {
    pass_glass(arrival, step);
    return;
  }
  // Light that is drawn would reach a point inside a body through its surface, which hides it.
  add_lit(arrival, bounces_at(arrival.leg) && arrival.medium == nullptr, step);
  if (bounces_at(arrival.leg)) {
    bounce(arrival, step);
  }
}

void ColorTracer::add_lit(const Arrival& arrival, bool is_drawn_to, Step& step) {
  const auto place = static_cast<std::size_t>(step.lit.points.size);
  add_point(step.lit.points, arrival.point);
  step.lit.legs[place] = &arrival.leg;
  step.lit.weights[place] = arrival.weight;
  step.lit.is_drawn_to[place] = is_drawn_to;
  step.lit.is_certain[place] = !arrival.material.layers.any();
  if (is_drawn_to) {
    step.lit.surfaces[place] = arrival.point;
    step.lit.reach[place] = arrival.reach;
  }
}

/// Returns the weight of what a surface emits along a leg: 1 where nothing else draws it; otherwise
/// of the direction that a bounce drew beside a place on an emitter, `add_emitters`.
float ColorTracer::weight_of_emission(const PathLegs& bundle, int lane,
                                      const SurfaceTriangle& triangle,
                                      const SurfacePoint& point) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  if (leg.density == 0 || point.emission.isZero(0) || !emitters_) {
    return 1;
  }
  const float drawn =
      emitters_->density(triangle, static_cast<std::size_t>(bundle.rays.mesh(lane)),
                         bundle.rays.triangle(lane), point, bundle.rays.lanes.ray.tfar[lane]);
  return sample_weight(leg.density, drawn);
}

/// Returns the fraction that a surface hides of what is behind it; in mode `path` 0 or 1 at random.
float ColorTracer::coverage(const Material& material, float alpha, const PathLeg& leg,
                            const Step& step) const {
  if (material.alpha_mode != AlphaMode::blend) {
    return 1;
  }
  if (mode_ == RenderMode::path) {
    return draw(step, leg, of_coverage_and_layer).x() < alpha ? 1.0F : 0.0F;
  }
  return std::clamp(alpha, 0.0F, 1.0F);
}

/// Continues a leg straight through a surface that hides a fraction `hidden` of what is behind.
void ColorTracer::pass(const PathLegs& bundle, int lane, float hidden, Step& step) {
  if (hidden >= 1) {
    return;
  }
  const RTCRay16& ray = bundle.rays.lanes.ray;
  PathLeg leg = bundle.legs[static_cast<std::size_t>(lane)];
  leg.weight *= 1 - hidden;
  step.add(leg, {{ray.org_x[lane], ray.org_y[lane], ray.org_z[lane]},
                 bundle.rays.direction(lane),
                 kBehind * ray.tfar[lane],
                 kUnlimited,
                 bundle.rays.share(lane)});
}

/// Returns the leg that continues a path from where it arrived, still with the old direction.
PathLeg ColorTracer::leg_from(const Arrival& arrival) {
  PathLeg next = arrival.leg;
  next.weight = arrival.weight;
  next.travelled = arrival.reach;
  next.medium = arrival.medium;
  next.is_straight = false;
  return next;
}

/// Continues a path in a direction drawn at random.
void ColorTracer::bounce(const Arrival& arrival, Step& step) const {
  const SurfacePoint& point = arrival.point;
  const Eigen::Vector2f choices = draw(step, arrival.leg, of_lobe_and_survival);
  const Scattered scattered = scatter(point, choices.x(), draw(step, arrival.leg, of_direction));
  PathLeg next = leg_from(arrival);
  next.weight = next.weight.cwiseProduct(scattered.weight);
  next.density = next.medium == nullptr ? scattered.density : 0;
  ++next.bounces;
  go_on(next, choices.y(), ray_from(point, scattered.direction), step);
}

/// Adds a leg to the next step: after the first reflection with the fourth root of its strongest
/// colour as probability, and as much stronger if so (Russian roulette). The colour itself ends so
/// many paths that the few that go on make more noise than they save time. `chance` is random in
/// [0, 1).
void ColorTracer::go_on(PathLeg next, float chance, const CameraRay& ray, Step& step) {
  const float strongest = std::min(1.0F, next.weight.maxCoeff());
  const float survival = next.bounces > 1 ? std::sqrt(std::sqrt(strongest)) : 1.0F;
  if (!next.weight.isZero(0) && chance < survival) {
    next.weight /= survival;
    step.add(next, ray);
  }
}

}  // namespace synth
