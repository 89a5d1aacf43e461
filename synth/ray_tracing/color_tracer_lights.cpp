#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "synth/ray_tracing/color_tracer.h"
#include "synth/ray_tracing/color_tracer_step.h"
#include "synth/shading/drawn_light.h"
#include "synth/shading/even_samples.h"
#include "synth/shading/glass.h"
#include "synth/shading/scatter.h"
#include "synth/shading/scrambled_sobol.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr int kMostWalls = 32;             // clear walls between a point and a lamp
constexpr float kToEmitter = 1 - 1e-5F;    // of the way, short of what Embree takes as a hit
constexpr std::uint64_t kLights = 0x9a74;  // purpose of the places on lights but in mode `path`

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

/// Returns one of the rays of a packet, from a point on it on.
CameraRay ray_of(const RTCRay16& rays, std::size_t place, float near) {
  return {{rays.org_x[place], rays.org_y[place], rays.org_z[place]},
          {rays.dir_x[place], rays.dir_y[place], rays.dir_z[place]},
          near,
          rays.tfar[place],
          rays.time[place]};
}

void add_tinted(const Lanes3& light, const PacketColors& tints, Lanes3& sum) {
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    sum.x[i] += light.x[i] * tints[i].x();
    sum.y[i] += light.y[i] * tints[i].y();
    sum.z[i] += light.z[i] * tints[i].z();
  }
}

}  // namespace

void ColorTracer::add_lights(Step& step) const {
  const LitLanes& lit = step.lit.points;
  ShadowPacket shadows = shadow_rays(lit);
  shadows.coherence = step.coherence();
  Lanes3 sum;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const PlacedLight& light = lights_[i];
    Lamp lamp{direct_light(light, places_on_light(i, step), lit, instruction_set_), light.intensity,
              shadow_reach(light)};
    add_lamp(lamp, step.memory.blockers[i], shadows, lit, sum);
  }
  const float seen = step.packet.scene_light();
  for (std::size_t i = 0; i < static_cast<std::size_t>(lit.size); ++i) {
    sum.x[i] *= seen;
    sum.y[i] *= seen;
    sum.z[i] *= seen;
  }
  show_lit(sum, light_radius_ == 0, step);
}

/// Adds the light of the camera's projectors, as if they were lamps.
void ColorTracer::add_projectors(Step& step) const {
  const std::vector<Projector>& projectors = step.packet.infrared->projectors;
  ShadowPacket shadows = shadow_rays(step.lit.points);
  Lanes3 sum;
  for (std::size_t i = 0; i < projectors.size(); ++i) {
    Lamp lamp = lamp_of(projectors[i], step);
    add_lamp(lamp, step.memory.projector_blockers[i], shadows, step.lit.points, sum);
  }
  show_lit(sum, true, step);
}

/// Returns the light of a projector where it is at each path's own instant.
ColorTracer::Lamp ColorTracer::lamp_of(const Projector& projector, const Step& step) const {
  const LitLanes& lit = step.lit.points;
  const vo::SE3 T_projector_camera = projector.T_camera_projector.inverse();
  Lanes3 places;
  Lanes pattern{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(lit.size); ++i) {
    const CameraPose& eye = step.packet.eyes[step.lit.legs[i]->sample];
    const Eigen::Vector3d p_world =
        Eigen::Vector3f(lit.position.x[i], lit.position.y[i], lit.position.z[i]).cast<double>() +
        world_.origin;
    pattern[i] = pattern_along(projector, T_projector_camera * (eye.R_world_camera.transpose() *
                                                                (p_world - eye.position)));
    const Eigen::Vector3f place = (eye.position - world_.origin +
                                   eye.R_world_camera * projector.T_camera_projector.translation())
                                      .cast<float>();
    places.x[i] = place.x();
    places.y[i] = place.y();
    places.z[i] = place.z();
  }
  const PlacedLight everywhere;
  Lamp lamp{direct_light(everywhere, places, lit, instruction_set_),
            Eigen::Vector3f::Constant(static_cast<float>(projector.power)),
            shadow_reach(everywhere)};
  std::transform(lamp.direct.share.begin(), lamp.direct.share.end(), pattern.begin(),
                 lamp.direct.share.begin(), std::multiplies<>());
  return lamp;
}

/// Adds the reflected light of a lamp to the points that nothing hides from it.
void ColorTracer::add_lamp(Lamp& lamp, Occluder& blocker, ShadowPacket& shadows,
                           const LitLanes& lit, Lanes3& sum) const {
  aim_at_light(shadows, lamp.direct, lamp.reach);
  const ShadowCasters casters =
      has_clear_walls_ ? ShadowCasters::all_but_clear_walls : ShadowCasters::all;
  if (!cast_shadows(shadows, lamp.reach, blocker, casters)) {
    return;
  }
  lamp.direct.keep(shadows.active);
  Lanes3 reflected;
  add_reflected(lit, lamp.direct, lamp.intensity, instruction_set_,
                has_clear_walls_ ? reflected : sum);
  if (has_clear_walls_) {
    add_tinted(reflected, light_through_walls(shadows), sum);
  }
}

/// Adds the reflected light of lamps to the colours; `is_certain` says that no random number
/// decides it.
void ColorTracer::show_lit(const Lanes3& light, bool is_certain, Step& step) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(step.lit.points.size); ++i) {
    const Eigen::Vector3f radiance =
        step.lit.weights[i].cwiseProduct(Eigen::Vector3f(light.x[i], light.y[i], light.z[i]));
    step.colors[step.lit.legs[i]->sample] += radiance;
    FirstSight* sight = step.sight_of(*step.lit.legs[i]);
    if (sight != nullptr && is_certain && step.lit.is_certain[i]) {
      sight->shown += radiance;
    }
  }
}

/// Adds the reflected light of one drawn direction to each point where a path bounces.
/// `draw_light` draws it for one of these.
template <typename DrawLight>
void ColorTracer::add_drawn(DrawLight draw_light, float reach, Occluder& occluder,
                            Step& step) const {
  const LitLanes& lit = step.lit.points;
  const auto size = static_cast<std::size_t>(lit.size);
  LightLanes direct;
  PacketColors radiance;
  for (std::size_t i = 0; i < size; ++i) {
    if (step.lit.is_drawn_to[i]) {
      const DrawnLight light = draw_light(i);
      radiance[i] = light.radiance;
      direct.set(i, light.to_light, irradiance_share(step.lit.surfaces[i], light));
    }
  }
  ShadowPacket shadows = shadow_rays(lit);
  shadows.coherence = step.coherence();
  aim_at_light(shadows, direct, reach);
  if (!cast_shadows(shadows, reach, occluder, ShadowCasters::all)) {
    return;
  }
  direct.keep(shadows.active);
  Lanes3 sum;
  add_reflected(lit, direct, Eigen::Vector3f::Ones(), instruction_set_, sum);
  for (std::size_t i = 0; i < size; ++i) {
    if (direct.share[i] > 0) {
      step.colors[step.lit.legs[i]->sample] +=
          step.packet.scene_light() *
          step.lit.weights[i]
              .cwiseProduct(radiance[i])
              .cwiseProduct(Eigen::Vector3f(sum.x[i], sum.y[i], sum.z[i]));
    }
  }
}

/// Adds the light of one place on an emitter to each point.
void ColorTracer::add_emitters(Step& step) const {
  const auto draw_light = [&](std::size_t i) {
    const PathLeg& leg = *step.lit.legs[i];
    const SurfacePoint& point = step.lit.surfaces[i];
    const Eigen::Vector3f start = point.position + point.rounding * point.face_normal;
    return emitters_->draw({start, point.share, draw(step, leg, of_emitter).x(),
                            draw(step, leg, of_place_on_emitter), step.lit.reach[i],
                            step.packet.sample_width});
  };
  add_drawn(draw_light, kToEmitter, step.memory.blockers[lights_.size()], step);
}

/// Adds the light of one direction of the environment to each point.
void ColorTracer::add_environment(Step& step) const {
  const auto draw_light = [&](std::size_t i) {
    return environment_directions_->draw(draw(step, *step.lit.legs[i], of_place_in_environment));
  };
  add_drawn(draw_light, kUnlimited, step.memory.blockers[lights_.size() + 1], step);
}

/// Traces shadow rays and deactivates those that hit something. Returns whether any are left.
bool ColorTracer::cast_shadows(ShadowPacket& shadows, float reach, Occluder& occluder,
                               ShadowCasters casters) const {
  if (!shadows.has_rays() || !occluder.stop(shadows, reach, instruction_set_)) {
    return false;
  }
  ShadowHit hit;
  embree_.occlude(shadows, hit, casters);
  if (hit.mesh != kNone && !occluder.is(hit)) {
    occluder = Occluder(world_, hit);
  }
  return shadows.has_rays();
}

/// Returns what clear walls let through of the light along each active ray, which meets nothing
/// else that is solid; nothing where there are too many.
PacketColors ColorTracer::light_through_walls(const ShadowPacket& shadows) const {
  PacketColors shares;
  shares.fill(Eigen::Vector3f::Ones());
  HitPacket packet;
  std::array<std::size_t, kPacketSize> places;
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    if (shadows.active[i] != 0) {
      places[static_cast<std::size_t>(packet.size)] = i;
      add_ray(packet, ray_of(shadows.lanes, i, 0));
    }
  }
  for (int met = 0; packet.size > 0 && met < kMostWalls; ++met) {
    embree_.intersect(packet, Sight::solid);
    HitPacket onward;
    for (int lane = 0; lane < packet.size; ++lane) {
      const std::size_t place = places[static_cast<std::size_t>(lane)];
      if (!packet.has_hit(lane)) {
        continue;
      }
      const SurfaceTriangle triangle(world_, packet.mesh(lane), packet.triangle(lane),
                                     packet.share(lane));
      if (is_clear_wall(*triangle.mesh->material)) {
        const SurfacePoint point = surface_point(
            triangle, {packet.weights(lane), packet.direction(lane), 0, packet.share(lane)});
        shares[place] = shares[place].cwiseProduct(straight_share(point, *triangle.mesh->material));
      }
      places[static_cast<std::size_t>(onward.size)] = place;
      add_ray(onward, ray_of(shadows.lanes, place, kBehind * packet.lanes.ray.tfar[lane]));
    }
    packet = onward;
  }
  for (int lane = 0; lane < packet.size; ++lane) {
    shares[places[static_cast<std::size_t>(lane)]].setZero();
  }
  return shares;
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
