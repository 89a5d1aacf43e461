#pragma once

#include <array>
#include <complex>
#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/rendering/multipath.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/lanes.h"
#include "synth/shading/shading_lanes.h"
#include "synth/shading/surface.h"
#include "vo/core/instruction_set.h"
#include "vo/core/random_field.h"

namespace synth {

/// The opaque surface that a pixel of a depth camera sees.
struct SeenPoint {
  cv::Point pixel;
  SurfacePoint point;
  float distance = 0;  ///< m, optical path along the line of sight
  float spread = 0;    ///< m, by whose square the lamp's light has fallen there
  float share = 1;     ///< of the radiance, what the pixel sees through clear surfaces before it
};

/// The points that neighbouring pixels see, in the first `size` lanes.
struct SeenPoints {
  int size = 0;
  std::array<SeenPoint, kPacketSize> lanes;
};

/// Follows the light that a time-of-flight camera sees by way of other surfaces, as
/// MultipathOptions say. Its surfaces reflect as glTF's materials do, with the mean of red, green
/// and blue as their colour. A path goes on from smooth glass and mirrors as DepthSight does, but
/// the highlight of the lamp on them does not light other surfaces; clear walls let all light of
/// the lamp pass to those. Refers to its arguments, which must outlive it.
class MultipathTracer {
 public:
  MultipathTracer(const WorldGeometry& world, const EmbreeScene& embree, const View& view)
      : world_(world),
        embree_(embree),
        view_(view),
        options_(view.multipath()),
        wave_number_(options_.wave_number()),
        random_(options_.seed, kPurpose, 0) {}

  /// Complex numbers, one for each lane.
  using Phasors = std::array<std::complex<double>, kPacketSize>;

  /// Returns DepthSight::multipath of each point.
  Phasors trace(const SeenPoints& seen) const;

 private:
  struct Path;
  struct Paths;
  static constexpr std::uint64_t kPurpose = 0x70f3;  ///< of the random numbers

  void add_sample(const SeenPoints& seen, int sample, Phasors& sums) const;
  Paths next_surfaces(const SeenPoints& seen, const Paths& paths, int sample, int step) const;
  static CameraRay go_on(std::uint64_t bits, int index, Path& path);
  Path arrival(const Path& leaving, const HitPacket& rays, int lane) const;
  LightLanes light_of_lamp(const SeenPoints& seen, const Paths& paths, const LitLanes& lit) const;
  void add_lamp(const SeenPoints& seen, const Paths& paths, Phasors& sums) const;
  bool is_in_lamp_field(const Eigen::Vector3f& position, int v) const;

  const WorldGeometry& world_;
  const EmbreeScene& embree_;
  const View& view_;
  const MultipathOptions& options_;
  double wave_number_;  ///< rad/m
  vo::RandomField random_;
  vo::InstructionSet instruction_set_ = vo::available_instruction_set();
};

}  // namespace synth
