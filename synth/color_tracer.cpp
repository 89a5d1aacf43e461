#include "synth/color_tracer.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "synth/even_samples.h"
#include "synth/random.h"
#include "synth/scatter.h"

namespace synth {
namespace {

constexpr float kUnlimited = std::numeric_limits<float>::infinity();
constexpr int kMaxLayers = 32;  // blended surfaces behind each other; what lies behind is black

/// What a ray draws random numbers for, at each surface it meets; the lights come last.
enum Use : std::size_t { of_direction, of_lobe, of_coverage, of_lights };

constexpr std::uint64_t kPaths = 0x9a74;  // the purpose of their random numbers

}  // namespace

struct ColorTracer::LitPoints {
  std::array<SurfacePoint, kPacketSize> points;
  std::array<const PathLeg*, kPacketSize> legs;
  std::array<Eigen::Vector3f, kPacketSize> weights;
  std::size_t size = 0;
};

/// All legs of a packet advance by one surface.
struct ColorTracer::Step {
  Step(const ColorPacket& traced, LastTriangle<SurfaceTriangle>& last_hit, PacketColors& sums)
      : packet(traced), last(last_hit), colors(sums) {}

  void add(const PathLeg& leg, const Aim& aim) {
    next.legs[static_cast<std::size_t>(next.rays.size)] = leg;
    add_ray(next.rays, aim);
  }

  const ColorPacket& packet;
  LastTriangle<SurfaceTriangle>& last;
  PacketColors& colors;
  int index = 0;  ///< of the step
  LitPoints lit;
  PathLegs next;
};

ColorTracer::ColorTracer(const FlatScene& flat, const EmbreeScene& embree,
                         const RenderOptions& options)
    : flat_(flat),
      embree_(embree),
      mode_(options.mode),
      bounces_(options.bounces),
      light_radius_(static_cast<float>(options.light_radius)),
      ambient_(ambient_light(flat, options.ambient)),
      lights_(place_lights(flat)) {}

PacketColors ColorTracer::trace(ColorPacket& packet, LastTriangle<SurfaceTriangle>& last) const {
  PacketColors colors;
  colors.fill(Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    packet.start.legs[i] = {i, Eigen::Vector3f::Ones(), 0, 0};
  }
  Step step(packet, last, colors);
  advance(packet.start, step);
  while (step.next.rays.size > 0 && step.index < bounces_ + kMaxLayers) {
    PathLegs legs = step.next;
    step.next.rays.size = 0;
    step.lit.size = 0;
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
  for (std::size_t light = 0; step.lit.size > 0 && light < lights_.size(); ++light) {
    add_light(light, step);
  }
}

/// Behind everything it is dark for the camera; what was reflected towards there is lit from there.
void ColorTracer::end_leg(const PathLegs& bundle, int lane, PacketColors& colors) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  if (leg.bounces > 0) {
    colors[leg.sample] += leg.weight.cwiseProduct(ambient_.radiance(bundle.rays.direction(lane)));
  }
}

void ColorTracer::meet_surface(const PathLegs& bundle, int lane, Step& step) const {
  const PathLeg& leg = bundle.legs[static_cast<std::size_t>(lane)];
  const auto make = [&](int mesh, int triangle) {
    return SurfaceTriangle(flat_, mesh, triangle, bundle.rays.share(lane));
  };
  if (!flat_.meshes[static_cast<std::size_t>(bundle.rays.mesh(lane))].moments.empty()) {
    step.last = {};
  }
  const SurfaceTriangle& triangle =
      step.last.get(bundle.rays.mesh(lane), bundle.rays.triangle(lane), make);
  const Material& material = *triangle.mesh->material;
  if (!material.unlit && mode_ != RenderMode::unlit) {
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
  SurfacePoint& point = step.lit.points[step.lit.size];
  point = surface_point(triangle, {bundle.rays.weights(lane), bundle.rays.direction(lane),
                                   step.packet.sample_width * reach, bundle.rays.share(lane)});
  const float share = coverage(*triangle.mesh->material, point.alpha, leg, step);
  pass(bundle, lane, share, step);
  if (share == 0) {
    return;
  }
  const Eigen::Vector3f weight = share * leg.weight;
  Eigen::Vector3f radiance = point.emission;
  if (mode_ == RenderMode::direct) {
    radiance += reflect_ambient(point, ambient_);
  }
  step.colors[leg.sample] += weight.cwiseProduct(radiance);
  step.lit.legs[step.lit.size] = &leg;
  step.lit.weights[step.lit.size] = weight;
  ++step.lit.size;
  if (mode_ == RenderMode::path && leg.bounces < bounces_) {
    PathLeg next = leg;
    next.travelled = reach;
    bounce(next, point, step);
  }
}

/// How much of what is behind the surface it hides. A path goes one way or the other by chance.
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

/// Straight on through what is not hidden.
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

void ColorTracer::bounce(const PathLeg& leg, const SurfacePoint& point, Step& step) const {
  const Scattered scattered =
      scatter(point, draw(step, leg, of_lobe).x(), draw(step, leg, of_direction));
  PathLeg next = leg;
  next.weight = leg.weight.cwiseProduct(scattered.weight);
  ++next.bounces;
  if (!next.weight.isZero(0)) {
    step.add(next, {point.position + point.rounding * point.face_normal, scattered.direction, 0,
                    kUnlimited, point.share});
  }
}

void ColorTracer::add_light(std::size_t light_index, Step& step) const {
  PlacedLight light = lights_[light_index];
  ShadowPacket shadows;
  std::array<std::size_t, kPacketSize> lit;  // of the step, one per shadow ray
  std::array<DirectLight, kPacketSize> direct;
  for (std::size_t i = 0; i < step.lit.size; ++i) {
    const SurfacePoint& point = step.lit.points[i];
    if (light_radius_ > 0 && light.has_place()) {
      light.position = place_on_light(lights_[light_index], point,
                                      draw(step, *step.lit.legs[i], of_lights + light_index));
    }
    const auto next = static_cast<std::size_t>(shadows.size);
    direct[next] = direct_light(light, point);
    if (!direct[next].irradiance.isZero(0)) {
      lit[next] = i;
      add_ray_to_light(shadows, point, direct[next], light);
    }
  }
  if (shadows.size == 0) {
    return;
  }
  embree_.occlude(shadows);
  for (int lane = 0; lane < shadows.size; ++lane) {
    if (!shadows.is_occluded(lane)) {
      const auto ray = static_cast<std::size_t>(lane);
      const std::size_t i = lit[ray];
      step.colors[step.lit.legs[i]->sample] +=
          step.lit.weights[i].cwiseProduct(reflect_light(step.lit.points[i], direct[ray]));
    }
  }
}

/// A point of the disc that a light shows to a surface, m.
Eigen::Vector3f ColorTracer::place_on_light(const PlacedLight& light, const SurfacePoint& point,
                                            const Eigen::Vector2f& random) const {
  const Frame frame((light.position - point.position).normalized());
  const Eigen::Vector2f place = light_radius_ * on_disc(random);
  return light.position + frame.x * place.x() + frame.y * place.y();
}

/// No two draws of a path are the same.
Eigen::Vector2f ColorTracer::draw(const Step& step, const PathLeg& leg, std::size_t use) const {
  const std::size_t uses = of_lights + lights_.size();
  const auto purpose = static_cast<int>(static_cast<std::size_t>(step.index) * uses + use);
  const SampleId& id = step.packet.ids[leg.sample];
  const RandomField field(step.packet.seed, kPaths, 0);
  return even_square(field.bits(id.pixel.x, id.pixel.y, purpose), id.sample);
}

}  // namespace synth
