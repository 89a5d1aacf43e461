#pragma once

#include <cstdint>
#include <vector>

#include "synth/scene/world_geometry.h"

namespace synth {

/// Of each flat mesh.
struct SurfaceIds {
  std::vector<std::uint16_t> instance;  ///< 1 + index in Scene::instances
  std::vector<std::uint16_t> material;  ///< 1 + index in Scene::materials, 1 + their number if none
};

/// Throws vo::Error beyond 65535.
SurfaceIds surface_ids(const WorldGeometry& world);

}  // namespace synth
