#pragma once

#include <Eigen/Core>

#include "synth/shading/lanes.h"
#include "synth/shading/shading.h"
#include "synth/shading/surface.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// The shading inputs of surface points: SurfacePoint's values, in the first `size` lanes.
struct LitLanes {
  int size = 0;
  Lanes3 position;
  Lanes3 start;  ///< m, origin of shadow rays: off the surface by its rounding
  Lanes3 face_normal;
  Lanes3 normal;
  Lanes3 to_viewer;
  Lanes3 base_color;
  Lanes scene_share{};  ///< SurfacePoint::share
  Lanes metallic{};
  Lanes specular{};
  Lanes alpha2{};  ///< square of ggx_alpha
  Lanes3 normal_reflectance;
};

void add_point(LitLanes& lit, const SurfacePoint& point);

/// The light of one source at each point without occluders.
struct LightLanes {
  Lanes3 to_light;  ///< DirectLight::to_light of each point
  Lanes share{};    ///< irradiance per intensity; zero behind the surface and beyond the last point

  void set(std::size_t lane, const Eigen::Vector3f& to_light_of_lane, float share_of_lane);

  /// Sets the light to zero in inactive lanes.
  void keep(const LaneMask& active);
};

/// Returns the light's position, m, in every lane.
Lanes3 same_place(const PlacedLight& light);

/// Returns the unoccluded light of every lane. `places` are positions on the light, m, which
/// directional lights ignore.
LightLanes direct_light(const PlacedLight& light, const Lanes3& places, const LitLanes& lit,
                        vo::InstructionSet set);

/// Adds the reflected radiance of a light of this intensity to each lane.
void add_reflected(const LitLanes& lit, const LightLanes& light, const Eigen::Vector3f& intensity,
                   vo::InstructionSet set, Lanes3& radiance);

}  // namespace synth
