#include "synth/scene/vertex_sample.h"

#include <cstddef>

namespace synth {

std::vector<Eigen::Vector3d> sample_vertices(const Scene& scene) {
  constexpr std::size_t kMost = std::size_t{1} << 20U;
  const auto positions_of = [&](const Instance& instance) -> const std::vector<Eigen::Vector3f>& {
    static const std::vector<Eigen::Vector3f> kNoPositions;
    return instance.mesh == kNone ? kNoPositions : scene.meshes[at(instance.mesh)].positions;
  };
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) {
    count += positions_of(instance).size();
  }
  const std::size_t step = count / kMost + 1;
  std::vector<Eigen::Vector3d> sample;
  std::size_t next = 0;  // counted from the instance's first vertex
  for (const Instance& instance : scene.instances) {
    const std::vector<Eigen::Vector3f>& positions = positions_of(instance);
    for (; next < positions.size(); next += step) {
      sample.emplace_back(instance.T_world_mesh * positions[next].cast<double>());
    }
    next -= positions.size();
  }
  return sample;
}

}  // namespace synth
