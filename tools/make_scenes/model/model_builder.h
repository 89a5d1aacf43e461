#pragma once

#include <string>

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Assembles a Model: calls return the index by which later ones refer to their result.
class ModelBuilder {
 public:
  explicit ModelBuilder(const std::string& name) { model_.name = name; }

  int add_mesh(Mesh mesh);
  /// Adds a node without a mesh and returns its index; `parent` may be kNone.
  int add_group(int parent, const std::string& name, const Eigen::Isometry3d& T_parent_group);
  int place(int parent, const std::string& name, int mesh, const Eigen::Isometry3d& T_parent_mesh,
            double scale = 1);
  /// Adds a node of `kNone` parent that shows a mesh as its skin's joints bend it.
  void place_skinned(const std::string& name, int mesh, Skin skin);
  void add_light(int parent, const Light& light, const Eigen::Isometry3d& T_parent_light);

  /// Adds a node's motion and sets its rest pose to the first pose.
  void add_motion(Motion motion);

  const Model& model() const { return model_; }

 private:
  int add_node(int parent, Node node);

  Model model_;
};

}  // namespace scenes
