#pragma once

#include <cstdint>
#include <vector>

#include "synth/scene/world_geometry.h"

namespace synth {

/// The 16-bit ids of each flat mesh of a world geometry.
struct SurfaceIds {
  std::vector<std::uint16_t> instance;  ///< 1 + index in Scene::instances
  std::vector<std::uint16_t> material;  ///< 1 + index in Scene::materials; 1 + their count if none
};

/// Throws vo::Error if an id of the scene's instances or materials would exceed 65535.
void require_16_bit_ids(const Scene& scene);

/// Returns the ids of all meshes. Throws as require_16_bit_ids does.
SurfaceIds surface_ids(const WorldGeometry& world);

}  // namespace synth
