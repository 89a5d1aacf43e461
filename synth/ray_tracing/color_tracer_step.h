#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "synth/ray_tracing/color_tracer.h"
#include "synth/shading/shading_lanes.h"

/// The state that ColorTracer's functions share while a packet is traced.
namespace synth {

inline constexpr float kUnlimited = std::numeric_limits<float>::infinity();
inline constexpr float kBehind = 1 + 1e-5F;  ///< of the way to a surface, where a ray goes on

/// The uses of a path's random numbers at each surface that it meets; the lights come last.
enum PathNumber : std::size_t {
  of_direction,
  of_lobe_and_survival,
  of_coverage_and_layer,
  of_emitter,
  of_place_on_emitter,
  of_place_in_environment,
  of_lights
};

/// A leg that meets a lit surface.
struct ColorTracer::Arrival {
  const PathLeg& leg;
  const Material& material;
  const Material* medium;  ///< of the body that the leg went through; null in air
  SurfacePoint point;
  Eigen::Vector3f weight;  ///< linear RGB throughput of the path up to the point
  float reach;             ///< m, path length from the camera
};

struct ColorTracer::LitPoints {
  LitLanes points;
  std::array<const PathLeg*, kPacketSize> legs;
  std::array<Eigen::Vector3f, kPacketSize> weights;
  std::array<SurfacePoint, kPacketSize> surfaces;  ///< those that are drawn to
  Lanes reach;                                     ///< m, path length from the camera
  std::array<bool, kPacketSize> is_drawn_to;       ///< light is drawn beside a bounce there
  std::array<bool, kPacketSize> is_certain;        ///< no layer of the surface was chosen at random
};

/// The light of one lamp, or of one projector, at the lit points of a step.
struct ColorTracer::Lamp {
  LightLanes direct;          ///< without occluders
  Eigen::Vector3f intensity;  ///< linear RGB, cd; directional: lx
  float reach;                ///< of shadow rays, in lengths of LightLanes::to_light
};

/// The state of a step in which all legs of a packet advance by one surface.
struct ColorTracer::Step {
  Step(const ColorPacket& traced, ColorMemory& remembered, PacketColors& sums,
       PacketSights* first_sights)
      : packet(traced), memory(remembered), colors(sums), sights(first_sights) {}

  /// Returns the sight of the leg's ray, null if it has left the first surface or none is kept.
  FirstSight* sight_of(const PathLeg& leg) const {
    return sights != nullptr && leg.is_straight ? &(*sights)[leg.sample] : nullptr;
  }

  void add(const PathLeg& leg, const CameraRay& ray) {
    next.legs[static_cast<std::size_t>(next.rays.size)] = leg;
    add_ray(next.rays, ray);
  }

  const ColorPacket& packet;
  ColorMemory& memory;
  PacketColors& colors;
  PacketSights* sights;
  int index = 0;                                  ///< number of steps before this one
  std::array<std::uint64_t, kPacketSize> bits{};  ///< random in mode `path`, of each sample's pixel
  LitPoints lit;
  PathLegs next;

  /// Rays of a packet that the camera sent go side by side; after a reflection none do.
  Coherence coherence() const { return index == 0 ? Coherence::coherent : Coherence::incoherent; }
};

}  // namespace synth
