#pragma once

#include <string>

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Puts a Model together: every call gives the index by which later ones refer to its result.
class ModelBuilder {
 public:
  explicit ModelBuilder(const std::string& name) { model_.name = name; }

  int add_mesh(Mesh mesh);
  /// `parent` may be kNone.
  int add_group(int parent, const std::string& name, const Eigen::Isometry3d& T_parent_group);
  int place(int parent, const std::string& name, int mesh, const Eigen::Isometry3d& T_parent_mesh,
            double scale = 1);
  void add_light(int parent, const Light& light, const Eigen::Isometry3d& T_parent_light);

  /// Moves a node; it rests at the first of the poses where nothing plays the animation.
  void add_motion(Motion motion);

  const Model& model() const { return model_; }

 private:
  int add_node(int parent, Node node);

  Model model_;
};

}  // namespace scenes
