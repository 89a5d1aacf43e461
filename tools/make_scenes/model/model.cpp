#include "tools/make_scenes/model/model.h"

#include <algorithm>
#include <iterator>

namespace scenes {

void add(Mesh& mesh, Finish finish, const Shape& shape, const Eigen::Isometry3d& T_mesh_shape) {
  auto part = std::find_if(mesh.parts.begin(), mesh.parts.end(),
                           [&](const MeshPart& candidate) { return candidate.finish == finish; });
  if (part == mesh.parts.end()) {
    mesh.parts.push_back({finish, {}});
    part = std::prev(mesh.parts.end());
  }
  append(part->shape, shape, T_mesh_shape);
}

}  // namespace scenes
