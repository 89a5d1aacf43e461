#include "synth/rendering/surface_ids.h"

#include <cstddef>
#include <limits>

#include "vo/core/error.h"

namespace synth {
namespace {

void require_16_bits(std::size_t count, const char* what) {
  constexpr std::size_t kMax = std::numeric_limits<std::uint16_t>::max();
  vo::require(count <= kMax, "ground truth: the scene has ", count, " ", what,
              ", expected at most ", kMax, " for 16-bit ids");
}

}  // namespace

void require_16_bit_ids(const Scene& scene) {
  require_16_bits(scene.instances.size(), "instances");
  require_16_bits(scene.materials.size() + 1, "materials and the default");
}

SurfaceIds surface_ids(const WorldGeometry& world) {
  const std::size_t materials = world.scene->materials.size();
  require_16_bit_ids(*world.scene);
  SurfaceIds ids;
  for (const FlatMesh& mesh : world.meshes) {
    const int material = mesh.mesh->material;
    ids.instance.push_back(static_cast<std::uint16_t>(mesh.instance + 1));
    ids.material.push_back(
        static_cast<std::uint16_t>(1 + (material == kNone ? materials : material)));
  }
  return ids;
}

}  // namespace synth
