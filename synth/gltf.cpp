#include "synth/gltf.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synth/gltf_check.h"
#include "synth/gltf_file.h"
#include "synth/gltf_material.h"
#include "synth/gltf_mesh.h"
#include "synth/gltf_model.h"
#include "synth/gltf_notes.h"
#include "synth/gltf_placed.h"
#include "vo/core/error.h"

namespace synth {
namespace {

/// Bounds what nodes that share a mesh of many primitives may multiply to.
constexpr std::size_t kMostInstances = 1'000'000;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

Eigen::Affine3d T_parent_node(const tinygltf::Node& node) {
  Eigen::Affine3d T = Eigen::Affine3d::Identity();
  if (!node.matrix.empty()) {
    T.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    return T;
  }
  if (!node.translation.empty()) {
    T.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
  }
  if (!node.rotation.empty()) {
    T.rotate(Eigen::Map<const Eigen::Quaterniond>(node.rotation.data()).normalized());
  }
  if (!node.scale.empty()) {
    T.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
  }
  return T;
}

std::vector<int> all_roots(const tinygltf::Model& model) {
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) {
      is_child[at(child)] = true;
    }
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) {
      roots.push_back(static_cast<int>(i));
    }
  }
  return roots;
}

/// The roots of the default scene, of the first if none is default, or all if there are no scenes.
std::vector<int> scene_roots(const tinygltf::Model& model) {
  if (model.scenes.empty()) {
    return all_roots(model);
  }
  return model.scenes[model.defaultScene == kNone ? 0 : at(model.defaultScene)].nodes;
}

class SceneReader {
 public:
  SceneReader(const GltfModel& model, Notes& notes)
      : model_(model), notes_(notes), materials_(model, scene_, notes) {}

  /// Walks the node trees level by level, in the document's order.
  Scene read() {
    struct Visit {
      int node;
      Eigen::Affine3d T_world_parent;
    };
    std::vector<Visit> visits;
    for (const int root : scene_roots(model_.content)) {
      visits.push_back({root, Eigen::Affine3d::Identity()});
    }
    for (std::size_t i = 0; i < visits.size(); ++i) {
      const Visit visit = visits[i];
      const tinygltf::Node& node = model_.content.nodes[at(visit.node)];
      const Eigen::Affine3d T_world_node = visit.T_world_parent * T_parent_node(node);
      vo::require(T_world_node.matrix().allFinite(), model_.place("nodes", visit.node),
                  ": its transform overflows, expected finite numbers");
      read_node(node, T_world_node);
      for (const int child : node.children) {
        visits.push_back({child, T_world_node});
      }
    }
    return std::move(scene_);
  }

 private:
  void read_node(const tinygltf::Node& node, const Eigen::Affine3d& T_world_node) {
    if (node.mesh != kNone) {
      add_instances(node.mesh, T_world_node);
    }
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end()) {
      add_light(light->second.Get("light").GetNumberAsInt(), T_world_node);
    }
    if (node.camera != kNone) {
      scene_.cameras.push_back(place_camera(model_.content.cameras[at(node.camera)], T_world_node));
      if (scene_.cameras.back().name.empty()) {
        scene_.cameras.back().name = node.name;
      }
    }
    if (node.skin != kNone) {
      add_note(notes_, "skinned meshes are left in their bind pose");
    }
  }

  void add_instances(int mesh, const Eigen::Affine3d& T_world_mesh) {
    for (const int index : meshes_of(mesh)) {
      vo::require(scene_.instances.size() < kMostInstances, model_.path.string(),
                  ": has more instances of primitives than ", kMostInstances,
                  ", expected at most as many");
      scene_.instances.push_back({index, T_world_mesh});
    }
  }

  /// The scene's meshes for the primitives of a glTF mesh, read when first asked for.
  const std::vector<int>& meshes_of(int gltf_mesh) {
    const auto [entry, is_new] = meshes_.try_emplace(gltf_mesh);
    if (is_new) {
      const auto& primitives = model_.content.meshes[at(gltf_mesh)].primitives;
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const std::string place =
            model_.place("meshes", gltf_mesh) + ".primitives[" + std::to_string(i) + ']';
        std::optional<Mesh> mesh = read_primitive(model_, primitives[i], place, notes_);
        if (mesh && !mesh->triangles.empty()) {
          mesh->material = materials_.material(primitives[i].material);
          entry->second.push_back(static_cast<int>(scene_.meshes.size()));
          scene_.meshes.push_back(*std::move(mesh));
        }
      }
    }
    return entry->second;
  }

  void add_light(int index, const Eigen::Affine3d& T_world_light) {
    scene_.lights.push_back(place_light(model_.content.lights[at(index)], T_world_light));
    vo::require(scene_.lights.back().direction.squaredNorm() > 0, model_.path.string(),
                ": a light that has a direction is on a node of scale zero, expected a direction");
  }

  const GltfModel& model_;
  Notes& notes_;
  Scene scene_;
  MaterialReader materials_;
  std::map<int, std::vector<int>> meshes_;
};

void note_what_is_left_out(const nlohmann::json& document, Notes& notes) {
  if (document.contains("animations")) {
    add_note(notes, "animations are left out");
  }
  for (const std::string& name : document.value("extensionsUsed", std::vector<std::string>())) {
    if (!is_supported_extension(name)) {
      add_note(notes, "the extension " + name + " is ignored");
    }
  }
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, Notes* notes) {
  Notes ignored;
  Notes& left_out = notes != nullptr ? *notes : ignored;
  const GltfFile file = read_gltf_file(path);
  const GltfModel model = read_gltf_model(file);
  note_what_is_left_out(file.json, left_out);
  Scene scene = SceneReader(model, left_out).read();
  if (scene.instances.empty()) {
    add_note(left_out, "the default scene has no triangles");
  }
  return scene;
}

}  // namespace synth
