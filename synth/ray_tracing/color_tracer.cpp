#include "synth/ray_tracing/color_tracer.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "synth/shading/even_samples.h"
#include "synth/shading/scatter.h"
#include "synth/shading/scrambled_sobol.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr float kUnlimited = std::numeric_limits<float>::infinity();
constexpr float kToEmitter = 1 - 1e-5F;  // of the way, short of what Embree takes as a hit
constexpr int kMaxLayers = 32;  // blended surfaces along a path; what lies behind them is black

/// The uses of a path's random numbers at each surface that it meets; the lights come last.
enum Use : std::size_t {
  of_direction,
  of_lobe_and_survival,
  of_coverage,
  of_emitter,
  of_place_on_emitter,
  of_place_in_environment,
  of_lights
};

constexpr std::uint64_t kPaths = 0x9a75;   // purpose of the random numbers in mode `path`
constexpr std::uint64_t kLights = 0x9a74;  // purpose of the places on lights in other modes

/// Returns the irradiance per radiance of a drawn light at a point, weighted beside the direction
/// that a bounce draws there; zero if none arrives.
float irradiance_share(const SurfacePoint& point, const DrawnLight& light) {
  if (!(light.density > 0)) {
    return 0;
  }
  const Eigen::Vector3f direction = light.to_light.normalized();
  const float bounced = scatter_density(point, direction);
  const float cosine = point.normal.dot(direction);
  return bounced > 0 ? sample_weight(light.density, bounced) * cosine / light.density : 0;
}

}  // namespace

struct ColorTracer::LitPoints {
  LitLanes points;
  std::array<const PathLeg*, kPacketSize> legs;
  std::array<Eigen::Vector3f, kPacketSize> weights;
  std::array<SurfacePoint, kPacketSize> surfaces;  ///< in mode `path`
  Lanes reach;                                     ///< m, path length from the camera
};

/// The state of a step in which all legs of a packet advance by one surface.
struct ColorTracer::Step {
  Step(const ColorPacket& traced, ColorMemory& remembered, PacketColors& sums)
      : packet(traced), memory(remembered), colors(sums) {}

  void add(const PathLeg& leg, const CameraRay& ray) {
    next.legs[static_cast<std::size_t>(next.rays.size)] = leg;
    add_ray(next.rays, ray);
  }

  const ColorPacket& packet;
  ColorMemory& memory;
  PacketColors& colors;
  int index = 0;                                  ///< number of steps before this one
  std::array<std::uint64_t, kPacketSize> bits{};  ///< random in mode `path`, of each sample's pixel
  LitPoints lit;
  PathLegs next;
};

ColorTracer::ColorTracer(const WorldGeometry& world, const EmbreeScene& embree,
                         const RenderOptions& options)
    : world_(world),
      embree_(embree),
      mode_(options.mode),
      bounces_(options.bounces),
      light_radius_(static_cast<float>(options.light_radius)),
      ambient_(ambient_light(world, options.ambient)),
      lights_(place_lights(world)),
      emitters_(world),
      environment_(world.scene->environment.empty() ? EnvironmentLight()
                                                    : EnvironmentLight(world.scene->environment)) {}

ColorMemory ColorTracer::new_memory() const {
  return {.seen = {}, .blockers = std::vector<Occluder>(lights_.size() + 2)};
}

PacketColors ColorTracer::trace(ColorPacket& packet, ColorMemory& memory) const {
  PacketColors colors;
  colors.fill(Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    packet.start.legs[i] = {i, Eigen::Vector3f::Ones(), 0, 0};
  }
  Step step(packet, memory, colors);
  if (mode_ == RenderMode::path) {
    const vo::RandomField field(packet.seed, kPaths, 0);
    std::transform(packet.ids.begin(), packet.ids.begin() + packet.start.rays.size,
                   step.bits.begin(),
                   [&](const SampleId& id) { return field.bits(id.pixel.x, id.pixel.y); });
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
  embree_.intersect(bundle.rays, Sight::layers);
  for (int lane = 0; lane < bundle.rays.size; ++lane) {
    if (bundle.rays.has_hit(lane)) {
      meet_surface(bundle, lane, step);
    } else {
      end_leg(bundle, lane, step.colors);
    }
  }
  if (step.lit.points.size > 0) {
    add_lights(step);
  }
  const bool is_path = step.lit.points.size > 0 && mode_ == RenderMode::path;
  if (is_path && !emitters_.empty()) {
    add_emitters(step);
  }
  if (is_path && !environment_.empty()) {
    add_environment(step);
  }
}

void ColorTracer::end_leg(const PathLegs& bundle, int lane, PacketColors& colors) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  colors[leg.sample] += leg.weight.cwiseProduct(light_from_afar(leg, bundle.rays.direction(lane)));
}

/// Returns what a leg that hits nothing brings: of an environment its radiance, weighted after a
/// bounce, which `add_environment` draws beside; otherwise a camera ray sees black, a reflected ray
/// the ambient radiance.
Eigen::Vector3f ColorTracer::light_from_afar(const PathLeg& leg,
                                             const Eigen::Vector3f& direction) const {
  if (!environment_.empty()) {
    const Eigen::Vector3f unit = direction.normalized();
    const float weight =
        leg.bounces == 0 ? 1 : sample_weight(leg.density, environment_.density(unit));
    return weight * environment_.radiance(unit);
  }
  return leg.bounces == 0 ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : ambient_.radiance(direction);
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
  const Eigen::Vector4f color = surface_color(
      triangle,
      {bundle.rays.weights(lane), bundle.rays.direction(lane), step.packet.sample_width * reach});
  const float share = coverage(material, color.w(), leg, step);
  step.colors[leg.sample] += share * leg.weight.cwiseProduct(color.head<3>());
  pass(bundle, lane, share, step);
}

void ColorTracer::meet_lit_surface(const PathLegs& bundle, int lane,
                                   const SurfaceTriangle& triangle, Step& step) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  const float reach = leg.travelled + bundle.rays.lanes.ray.tfar[lane];
  const SurfacePoint point =
      surface_point(triangle, {bundle.rays.weights(lane), bundle.rays.direction(lane),
                               step.packet.sample_width * reach, bundle.rays.share(lane)});
  const float share = coverage(*triangle.mesh->material, point.alpha, leg, step);
  pass(bundle, lane, share, step);
  if (share == 0) {
    return;
  }
  const Eigen::Vector3f weight = share * leg.weight;
  Eigen::Vector3f radiance = weight_of_emission(bundle, lane, triangle, point) * point.emission;
  if (mode_ == RenderMode::direct) {
    radiance += reflect_ambient(point, ambient_);
  }
  step.colors[leg.sample] += weight.cwiseProduct(radiance);
  const auto place = static_cast<std::size_t>(step.lit.points.size);
  add_point(step.lit.points, point);
  step.lit.legs[place] = &leg;
  step.lit.weights[place] = weight;
  if (bounces_at(leg)) {
    step.lit.surfaces[place] = point;
    step.lit.reach[place] = reach;
    PathLeg next = leg;
    next.travelled = reach;
    bounce(next, point, step);
  }
}

/// Returns the weight of what a surface emits along a leg: 1 where nothing else draws it; after a
/// bounce, of the direction that the bounce drew beside a place on an emitter, `add_emitters`.
float ColorTracer::weight_of_emission(const PathLegs& bundle, int lane,
                                      const SurfaceTriangle& triangle,
                                      const SurfacePoint& point) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  if (leg.bounces == 0 || point.emission.isZero(0)) {
    return 1;
  }
  const float drawn =
      emitters_.density(triangle, static_cast<std::size_t>(bundle.rays.mesh(lane)),
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
    return draw(step, leg, of_coverage).x() < alpha ? 1.0F : 0.0F;
  }
  return std::clamp(alpha, 0.0F, 1.0F);
}

/// Continues a leg straight through a surface that hides a fraction `hidden` of what is behind.
void ColorTracer::pass(const PathLegs& bundle, int lane, float hidden, Step& step) {
  if (hidden >= 1) {
    return;
  }
  const RTCRay16& ray = bundle.rays.lanes.ray;
  constexpr float kBehind = 1 + 1e-5F;
  PathLeg leg = bundle.legs[static_cast<std::size_t>(lane)];
  leg.weight *= 1 - hidden;
  step.add(leg, {{ray.org_x[lane], ray.org_y[lane], ray.org_z[lane]},
                 bundle.rays.direction(lane),
                 kBehind * ray.tfar[lane],
                 kUnlimited,
                 bundle.rays.share(lane)});
}

/// Continues a leg in a direction drawn at random. After the first reflection it goes on with the
/// probability of its strongest colour, and is as much stronger if it does (Russian roulette).
void ColorTracer::bounce(const PathLeg& leg, const SurfacePoint& point, Step& step) const {
  const Eigen::Vector2f choices = draw(step, leg, of_lobe_and_survival);
  const Scattered scattered = scatter(point, choices.x(), draw(step, leg, of_direction));
  PathLeg next = leg;
  next.weight = leg.weight.cwiseProduct(scattered.weight);
  next.density = scattered.density;
  ++next.bounces;
  const float survival = next.bounces > 1 ? std::min(1.0F, next.weight.maxCoeff()) : 1.0F;
  if (!next.weight.isZero(0) && choices.y() < survival) {
    next.weight /= survival;
    step.add(next, {point.position + point.rounding * point.face_normal, scattered.direction, 0,
                    kUnlimited, point.share});
  }
}

void ColorTracer::add_lights(Step& step) const {
  const LitLanes& lit = step.lit.points;
  ShadowPacket shadows = shadow_rays(lit);
  Lanes3 sum;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const PlacedLight& light = lights_[i];
    LightLanes direct = direct_light(light, places_on_light(i, step), lit, instruction_set_);
    aim_at_light(shadows, direct, shadow_reach(light));
    if (cast_shadows(shadows, shadow_reach(light), step.memory.blockers[i])) {
      direct.keep(shadows.active);
      add_reflected(lit, direct, light.intensity, instruction_set_, sum);
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(lit.size); ++i) {
    step.colors[step.lit.legs[i]->sample] +=
        step.lit.weights[i].cwiseProduct(Eigen::Vector3f(sum.x[i], sum.y[i], sum.z[i]));
  }
}

/// Adds the reflected light of one drawn direction to each point; `radiance` comes from there.
void ColorTracer::add_drawn(LightLanes& direct, const PacketColors& radiance, float reach,
                            Occluder& occluder, Step& step) const {
  const LitLanes& lit = step.lit.points;
  ShadowPacket shadows = shadow_rays(lit);
  aim_at_light(shadows, direct, reach);
  if (!cast_shadows(shadows, reach, occluder)) {
    return;
  }
  direct.keep(shadows.active);
  Lanes3 sum;
  add_reflected(lit, direct, Eigen::Vector3f::Ones(), instruction_set_, sum);
  for (std::size_t i = 0; i < static_cast<std::size_t>(lit.size); ++i) {
    if (direct.share[i] > 0) {
      step.colors[step.lit.legs[i]->sample] +=
          step.lit.weights[i]
              .cwiseProduct(radiance[i])
              .cwiseProduct(Eigen::Vector3f(sum.x[i], sum.y[i], sum.z[i]));
    }
  }
}

/// Adds the light of one place on an emitter to each point where a path bounces.
void ColorTracer::add_emitters(Step& step) const {
  LightLanes direct;
  PacketColors radiance;
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.lit.points.size); ++i) {
    const PathLeg& leg = *step.lit.legs[i];
    if (!bounces_at(leg)) {
      continue;
    }
    const SurfacePoint& point = step.lit.surfaces[i];
    const DrawnLight light = emitters_.draw(
        {point.position, point.share, draw(step, leg, of_emitter).x(),
         draw(step, leg, of_place_on_emitter), step.lit.reach[i], step.packet.sample_width});
    radiance[i] = light.radiance;
    direct.set(i, light.to_light, irradiance_share(point, light));
  }
  add_drawn(direct, radiance, kToEmitter, step.memory.blockers[lights_.size()], step);
}

/// Adds the light of one direction of the environment to each point where a path bounces.
void ColorTracer::add_environment(Step& step) const {
  LightLanes direct;
  PacketColors radiance;
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.lit.points.size); ++i) {
    const PathLeg& leg = *step.lit.legs[i];
    if (bounces_at(leg)) {
      const DrawnLight light = environment_.draw(draw(step, leg, of_place_in_environment));
      radiance[i] = light.radiance;
      direct.set(i, light.to_light, irradiance_share(step.lit.surfaces[i], light));
    }
  }
  add_drawn(direct, radiance, kUnlimited, step.memory.blockers[lights_.size() + 1], step);
}

/// Traces shadow rays and deactivates those that hit something. Returns whether any are left.
bool ColorTracer::cast_shadows(ShadowPacket& shadows, float reach, Occluder& occluder) const {
  if (!shadows.has_rays() || !occluder.stop(shadows, reach, instruction_set_)) {
    return false;
  }
  ShadowHit hit;
  embree_.occlude(shadows, hit);
  if (hit.mesh != kNone && !occluder.is(hit)) {
    occluder = Occluder(world_, hit);
  }
  return shadows.has_rays();
}

/// Returns where each point sees the light, m: at a random point of the disc that faces the point.
Lanes3 ColorTracer::places_on_light(std::size_t light_index, const Step& step) const {
  const PlacedLight& light = lights_[light_index];
  Lanes3 places = same_place(light);
  if (light_radius_ == 0 || !light.has_place()) {
    return places;
  }
  const Lanes3& from = step.lit.points.position;
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.lit.points.size); ++i) {
    const Eigen::Vector3f position(from.x[i], from.y[i], from.z[i]);
    const Frame frame((light.position - position).normalized());
    const PathLeg& leg = *step.lit.legs[i];
    const Eigen::Vector2f square = mode_ == RenderMode::path
                                       ? draw(step, leg, of_lights + light_index)
                                       : draw_on_light(step, leg, light_index);
    const Eigen::Vector2f place = light_radius_ * on_disc(square);
    const Eigen::Vector3f moved = frame.x * place.x() + frame.y * place.y();
    places.x[i] += moved.x();
    places.y[i] += moved.y();
    places.z[i] += moved.z();
  }
  return places;
}

/// Returns two random numbers in [0, 1) in mode `path`, other ones for each step and use of a path.
Eigen::Vector2f ColorTracer::draw(const Step& step, const PathLeg& leg, std::size_t use) const {
  const std::size_t uses = of_lights + lights_.size();
  const std::uint64_t purpose = static_cast<std::size_t>(step.index) * uses + use;
  return scrambled_sobol(vo::mixed(step.bits[leg.sample] + purpose),
                         step.packet.ids[leg.sample].sample);
}

/// Returns two random numbers in [0, 1) for a light in modes other than `path`, whose samples of a
/// pixel have one light each in common and no other dimension.
Eigen::Vector2f ColorTracer::draw_on_light(const Step& step, const PathLeg& leg,
                                           std::size_t light_index) const {
  constexpr std::size_t kFirst = 3;  // of a step's indices, which are drawn from by lights alone
  const std::size_t indices = kFirst + lights_.size();
  const auto purpose =
      static_cast<int>(static_cast<std::size_t>(step.index) * indices + kFirst + light_index);
  const SampleId& id = step.packet.ids[leg.sample];
  const vo::RandomField field(step.packet.seed, kLights, 0);
  return even_square(field.bits(id.pixel.x, id.pixel.y, purpose), id.sample);
}

}  // namespace synth
