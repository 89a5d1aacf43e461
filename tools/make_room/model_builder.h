#pragma once

#include <string>

#include "tools/make_room/model.h"

namespace room {

/// Puts a Model together: every call gives the index by which later ones refer to its result.
class ModelBuilder {
 public:
  int add_mesh(Mesh mesh);
  /// `parent` may be kNone.
  int add_group(int parent, const std::string& name, const Eigen::Isometry3d& T_parent_group);
  int place(int parent, const std::string& name, int mesh, const Eigen::Isometry3d& T_parent_mesh,
            double scale = 1);
  void add_light(int parent, const Light& light, const Eigen::Isometry3d& T_parent_light);

  const Model& model() const { return model_; }

 private:
  int add_node(int parent, Node node);

  Model model_;
};

}  // namespace room
