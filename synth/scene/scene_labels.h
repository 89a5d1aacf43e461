#pragma once

#include <string>
#include <vector>

#include "synth/scene/scene.h"

namespace synth {

/// An InstanceLabel says where one of Scene::instances comes from. All indices but `file` are those
/// of its glTF file.
struct InstanceLabel {
  int file = 0;  ///< index in SceneLabels::files
  int node = kNone;
  int mesh = kNone;
  int primitive = 0;  ///< index within the mesh
  int copy = kNone;   ///< number, from 0, of the node's instance (EXT_mesh_gpu_instancing)
};

/// A MaterialLabel says where one of Scene::materials comes from.
struct MaterialLabel {
  int file = 0;  ///< index in SceneLabels::files
  int index = kNone;
};

/// The name of a node of a glTF file, empty if it has none, and the index of its parent.
struct NodeLabel {
  std::string name;
  int parent = kNone;
};

/// The names in a glTF file.
struct FileLabels {
  std::string name;                 ///< of the file, without its folder
  std::vector<NodeLabel> nodes;     ///< by index in the file
  std::vector<std::string> meshes;  ///< empty if there is none, by index in the file
};

/// SceneLabels say what the elements of a Scene are called in their files, and where they stand
/// there.
struct SceneLabels {
  std::vector<FileLabels> files;
  std::vector<InstanceLabel> instances;  ///< of each of Scene::instances
  std::vector<MaterialLabel> materials;  ///< of each of Scene::materials
};

/// Returns a node's name; its index in the file if it has none.
std::string node_name(const FileLabels& file, int node);

/// Returns the names of a node and of all nodes above it, the outermost first, with `/` between.
std::string node_path(const FileLabels& file, int node);

}  // namespace synth
