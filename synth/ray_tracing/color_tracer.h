#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/ray_tracing/hit_cache.h"
#include "synth/ray_tracing/occluder.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/emitters.h"
#include "synth/shading/shading.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// A colour sample of a pixel, which determines the random numbers of its path.
struct SampleId {
  cv::Point pixel;
  int sample = 0;  ///< index among the pixel's samples, or among those of its half
  int half = 0;    ///< of two halves of the samples, which are independent of each other
};

/// A straight segment of a light path, followed from the camera.
struct PathLeg {
  std::size_t sample;      ///< index of the path's sample in its packet
  Eigen::Vector3f weight;  ///< linear RGB throughput of the path up to here
  int bounces;             ///< number of reflections before this segment
  float travelled;         ///< m, path length before the ray's origin
  float density = 0;       ///< 1/sr, of its direction if lights are drawn beside it, otherwise 0
  const Material* medium = nullptr;  ///< of the body that it goes through; null in air
  bool is_straight = true;  ///< it goes on from the camera, neither bounced nor through glass
};

/// Path segments that are traced together.
struct PathLegs {
  HitPacket rays;
  std::array<PathLeg, kPacketSize> legs;
};

/// A packet of camera rays, each for one sample of a pixel.
struct ColorPacket {
  PathLegs start;  ///< the caller adds the rays, ColorTracer sets the legs
  std::array<SampleId, kPacketSize> ids;
  std::uint64_t seed = 0;                    ///< seed of the paths' random numbers
  float sample_width = 0;                    ///< m, width of a sample's cone at 1 m
  bool has_sides = false;                    ///< the samples' cones are not round
  std::array<RaySides, kPacketSize> sides;   ///< of each ray's cone that is not
  const InfraredBand* infrared = nullptr;    ///< null for a camera that sees colours
  std::array<CameraPose, kPacketSize> eyes;  ///< of each ray, where there are projectors

  /// Returns the share of the scene's light that the camera sees.
  float scene_light() const {
    return infrared == nullptr ? 1.0F : static_cast<float>(infrared->scene_light);
  }
};

/// The triangle and the occluders met last, which the next rays are likely to meet again.
struct ColorMemory {
  HitCache<SurfaceTriangle> seen;
  std::vector<Occluder> blockers;  ///< last occluder of each light, emitters, the environment
  std::vector<Occluder> projector_blockers;  ///< likewise of each projector
};

using PacketColors = std::array<Eigen::Vector3f, kPacketSize>;

/// A FirstSight is what a camera ray meets first, as far as no random number but the coverage
/// of a blended surface decides it.
struct FirstSight {
  Eigen::Vector3f shown = Eigen::Vector3f::Zero();        ///< linear RGB radiance without noise
  Eigen::Vector3f reflectance = Eigen::Vector3f::Zero();  ///< linear RGB
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();       ///< world, shading normal
  float nearness = 0;  ///< 1/m, inverse of CameraModel::depth; 0 if nothing is met
};

using PacketSights = std::array<FirstSight, kPacketSize>;

/// Computes the radiance that comes back along camera rays. The world-space geometry and Embree's
/// scene must outlive it.
class ColorTracer {
 public:
  ColorTracer(const WorldGeometry& world, const EmbreeScene& embree, const RenderOptions& options);

  /// Returns the linear RGB radiance of each ray. `memory` saves time but does not change it.
  /// `sights`, where given, are those of the rays, zero before.
  PacketColors trace(ColorPacket& packet, ColorMemory& memory,
                     PacketSights* sights = nullptr) const;

  /// Returns the memory of packets whose light is that of a capture.
  ColorMemory new_memory(const Capture& capture) const;

 private:
  struct Arrival;
  struct Lamp;
  struct LitPoints;
  struct Step;

  void advance(PathLegs& bundle, Step& step) const;
  void end_leg(const PathLegs& bundle, int lane, Step& step) const;
  Eigen::Vector3f light_from_afar(const PathLeg& leg, const Eigen::Vector3f& direction) const;
  void meet_surface(const PathLegs& bundle, int lane, Step& step) const;
  SurfaceRay surface_ray(const PathLegs& bundle, int lane, float reach, const Step& step) const;
  void meet_lit_surface(const PathLegs& bundle, int lane, const SurfaceTriangle& triangle,
                        Step& step) const;
  float coverage(const Material& material, float alpha, const PathLeg& leg, const Step& step) const;
  static void pass(const PathLegs& bundle, int lane, float hidden, Step& step);
  float weight_of_emission(const PathLegs& bundle, int lane, const SurfaceTriangle& triangle,
                           const SurfacePoint& point) const;
  const Material* medium_before(const PathLeg& leg, const Material& met, bool is_from_behind) const;
  static Eigen::Vector3f weight_at_end(const PathLegs& bundle, int lane, const Material* medium);
  static void show(const Eigen::Vector3f& radiance, const PathLeg& leg, Step& step);
  void scatter_from(Arrival arrival, Step& step) const;
  bool meet_layer(Arrival& arrival, const Step& step) const;
  void pass_glass(const Arrival& arrival, Step& step) const;
  static void add_lit(const Arrival& arrival, bool is_drawn_to, Step& step);
  static PathLeg leg_from(const Arrival& arrival);
  void bounce(const Arrival& arrival, Step& step) const;
  static void go_on(PathLeg next, float chance, const CameraRay& ray, Step& step);
  void add_lights(Step& step) const;
  void add_projectors(Step& step) const;
  void add_lamp(Lamp& lamp, Occluder& blocker, ShadowPacket& shadows, const LitLanes& lit,
                Lanes3& sum) const;
  Lamp lamp_of(const Projector& projector, const Step& step) const;
  static void show_lit(const Lanes3& light, bool is_certain, Step& step);
  void add_emitters(Step& step) const;
  void add_environment(Step& step) const;
  template <typename DrawLight>
  void add_drawn(DrawLight draw_light, float reach, Occluder& occluder, Step& step) const;
  bool cast_shadows(ShadowPacket& shadows, float reach, Occluder& occluder,
                    ShadowCasters casters) const;
  PacketColors light_through_walls(const ShadowPacket& shadows) const;
  Lanes3 places_on_light(std::size_t light_index, const Step& step) const;
  Eigen::Vector2f draw(const Step& step, const PathLeg& leg, std::size_t use) const;
  Eigen::Vector2f draw_on_light(const Step& step, const PathLeg& leg,
                                std::size_t light_index) const;
  bool bounces_at(const PathLeg& leg) const {
    return mode_ == RenderMode::path && leg.bounces < bounces_;
  }

  const WorldGeometry& world_;
  const EmbreeScene& embree_;
  RenderMode mode_;
  int bounces_;
  float light_radius_;            ///< m
  int anisotropy_;                ///< RenderOptions::anisotropy
  bool has_clear_walls_ = false;  ///< in mode `path`, some that lamps light through
  vo::InstructionSet instruction_set_ = vo::available_instruction_set();
  AmbientLight ambient_;
  std::vector<PlacedLight> lights_;
  EnvironmentLight environment_;
  std::optional<Emitters> emitters_;  ///< in mode `path`, drawn from where paths bounce, if any
  std::optional<EnvironmentDirections> environment_directions_;  ///< likewise
};

}  // namespace synth
