#include "tools/make_scenes/model/model_builder.h"

#include <cstddef>
#include <utility>

namespace scenes {

int ModelBuilder::add_mesh(Mesh mesh) {
  model_.meshes.push_back(std::move(mesh));
  return static_cast<int>(model_.meshes.size()) - 1;
}

int ModelBuilder::add_group(int parent, const std::string& name,
                            const Eigen::Isometry3d& T_parent_group) {
  return add_node(parent, {.name = name, .T_parent_node = T_parent_group});
}

int ModelBuilder::place(int parent, const std::string& name, int mesh,
                        const Eigen::Isometry3d& T_parent_mesh, double scale) {
  return add_node(parent,
                  {.name = name, .mesh = mesh, .T_parent_node = T_parent_mesh, .scale = scale});
}

void ModelBuilder::place_skinned(const std::string& name, int mesh, Skin skin) {
  model_.skins.push_back(std::move(skin));
  add_node(kNone, {.name = name, .mesh = mesh, .skin = static_cast<int>(model_.skins.size()) - 1});
}

void ModelBuilder::add_light(int parent, const Light& light,
                             const Eigen::Isometry3d& T_parent_light) {
  model_.lights.push_back(light);
  add_node(parent, {.name = light.name,
                    .light = static_cast<int>(model_.lights.size()) - 1,
                    .T_parent_node = T_parent_light});
}

void ModelBuilder::add_motion(Motion motion) {
  model_.nodes[static_cast<std::size_t>(motion.node)].T_parent_node = motion.T_parent_node.front();
  model_.motions.push_back(std::move(motion));
}

int ModelBuilder::add_node(int parent, Node node) {
  const int index = static_cast<int>(model_.nodes.size());
  model_.nodes.push_back(std::move(node));
  auto& siblings =
      parent == kNone ? model_.roots : model_.nodes[static_cast<std::size_t>(parent)].children;
  siblings.push_back(index);
  return index;
}

}  // namespace scenes
