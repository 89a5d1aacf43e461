#pragma once

#include <Eigen/Core>

#include "synth/shading/lanes.h"
#include "synth/shading/shading.h"
#include "synth/shading/surface.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// Surface points as light meets them: SurfacePoint's values, in the first `size` lanes.
struct LitLanes {
  int size = 0;
  Lanes3 position;
  Lanes3 start;  ///< m, of rays to the lights: off the surface by its rounding
  Lanes3 face_normal;
  Lanes3 normal;
  Lanes3 to_viewer;
  Lanes3 base_color;
  Lanes scene_share{};  ///< SurfacePoint::share
  Lanes metallic{};
  Lanes specular{};
  Lanes alpha2{};  ///< of ggx_alpha
};

void add_point(LitLanes& lit, const SurfacePoint& point);

/// One light as it reaches each point if nothing is between them.
struct LightLanes {
  Lanes3 to_light;  ///< DirectLight's
  Lanes share{};    ///< irradiance per intensity; zero behind the surface and beyond the last point

  /// Leaves the light only in active lanes.
  void keep(const LaneMask& active);
};

/// The same light for all lanes.
Lanes3 same_place(const PlacedLight& light);

/// direct_light() of every lane. `places` are the light's, m; not of directional ones.
LightLanes direct_light(const PlacedLight& light, const Lanes3& places, const LitLanes& lit,
                        vo::InstructionSet set);

/// Adds what comes back of the light at each lane.
void add_reflected(const LitLanes& lit, const LightLanes& light, const Eigen::Vector3f& intensity,
                   vo::InstructionSet set, Lanes3& radiance);

}  // namespace synth
