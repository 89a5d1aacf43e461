#include "synth/gltf/gltf_scene.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "synth/gltf/animation.h"
#include "synth/gltf/image_based_light.h"
#include "synth/gltf/instancing.h"
#include "synth/gltf/mesh.h"
#include "synth/gltf/placed_lights.h"
#include "synth/gltf/skin.h"
#include "synth/gltf_document/notes.h"
#include "synth/gltf_materials/material.h"
#include "synth/gltf_model/accessor.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/gltf_model/nodes.h"
#include "synth/gltf_model/select.h"
#include "synth/scene/scene_motion.h"
#include "synth/scene/shared_mesh.h"
#include "synth/scene/world_geometry.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// The limit of instances of primitives, as nodes that share a mesh multiply its primitives.
constexpr std::size_t kMostInstances = 1'000'000;

/// Bytes of a position and a normal, which renderers keep for each vertex of each instance that has
/// no shared mesh.
constexpr std::size_t kPlacedVertexBytes = 2 * sizeof(Eigen::Vector3f);

/// The limit of vertices of all instances, which bounds the time to visit each of them.
constexpr std::size_t kMostPlacedVertices = std::size_t{1} << 29U;

/// A glTF node that shows its mesh, once or as one of its instances.
struct ShownMesh {
  const tinygltf::Node& node;
  InstanceLabel label;    ///< its `primitive` is not set
  int moved_by = kNone;   ///< the node, as one of SceneMotion::nodes
  int stands_at = kNone;  ///< the node or instance that places the mesh, one of SceneMotion::nodes
};

/// One of Scene::meshes and the primitive of a glTF mesh that it was read from.
struct PrimitiveMesh {
  int mesh = kNone;
  int primitive = 0;
};

FileLabels names_in(const GltfModel& model) {
  const tinygltf::Model& content = model.content;
  FileLabels file{.name = model.path.filename().string()};
  file.nodes.resize(content.nodes.size());
  for (std::size_t i = 0; i < content.nodes.size(); ++i) {
    file.nodes[i].name = content.nodes[i].name;
    for (const int child : content.nodes[i].children) {
      file.nodes[at(child)].parent = static_cast<int>(i);
    }
  }
  for (const tinygltf::Mesh& mesh : content.meshes) {
    file.meshes.push_back(mesh.name);
  }
  return file;
}

class SceneReader {
 public:
  SceneReader(const GltfModel& model, const GltfOptions& options, Notes& notes)
      : model_(model),
        options_(options),
        reading_{model, notes, budget_},
        materials_(reading_, scene_, options.needed, options.scale),
        forest_(read_nodes(model.content, options.scale)),
        skins_(model.content.skins.size(), kNone),
        shining_{.scale = options.scale},
        is_read_(model.content.meshes.size(), false) {
    labels_.files.push_back(names_in(model));
  }

  LabelledScene read() {
    place_nodes();
    for (const int index : scene_nodes(model_, options_.scene)) {
      read_node(index);
    }
    check_the_rest();
    SceneMotion& motion = scene_.motion;
    motion.nodes = forest_.nodes;
    motion.loop = options_.loop;
    shining_.materials = materials_.sources();
    motion.animations = read_animations(reading_, {forest_, scene_, shining_}, options_.animation);
    read_brightness(model_, shining_, motion);
    Scene scene = at_rest();
    require_room(scene);
    require_within_world(scene, [&](std::size_t instance) {
      return model_.place("nodes", labels_.instances[instance].node);
    });
    scene.motion = std::move(motion);
    for (const int index : shining_.materials) {
      labels_.materials.push_back({.index = index});
    }
    return {std::move(scene), std::move(labels_)};
  }

 private:
  void place_nodes() {
    for (const MotionNode& node : forest_.nodes) {
      T_world_node_.push_back(node.parent == kNone
                                  ? node.T_parent_node
                                  : T_world_node_[at(node.parent)] * node.T_parent_node);
    }
  }

  /// Checks the meshes and skins that no node of the scene uses, and all accessors.
  void check_the_rest() {
    Notes unused;
    MemoryBudget budget;
    GltfReading reading{model_, unused, budget};
    for (std::size_t m = 0; m < model_.content.meshes.size(); ++m) {
      const auto& primitives = model_.content.meshes[m].primitives;
      for (std::size_t i = 0; i < primitives.size() && !is_read_[m]; ++i) {
        read_primitive(reading, primitives[i], place_of(static_cast<int>(m), i));
      }
    }
    for (std::size_t i = 0; i < skins_.size(); ++i) {
      if (skins_[i] == kNone) {
        read_skin(model_, static_cast<int>(i), forest_);
      }
    }
    for (std::size_t i = 0; i < model_.content.accessors.size(); ++i) {
      const int accessor = static_cast<int>(i);
      check_data(model_.content, accessor, model_.place("accessors", accessor));
    }
  }

  void read_node(int index) {
    const tinygltf::Node& node = model_.content.nodes[at(index)];
    const int moved_by = forest_.of_gltf[at(index)];
    const Eigen::Affine3d T_world_node = T_world_node_[at(moved_by)];
    require(T_world_node.matrix().allFinite(), model_.place("nodes", index),
            ": its transform overflows, expected finite numbers");
    if (node.mesh != kNone) {
      is_read_[at(node.mesh)] = true;
    }
    ShownMesh shown{node, {.node = index, .mesh = node.mesh}, moved_by, moved_by};
    if (node.mesh != kNone && is_instancing(node) && node.skin == kNone) {
      for (const int instance : instance_nodes(index)) {
        shown.stands_at = instance;
        ++shown.label.copy;
        add_mesh_of(shown);
      }
    } else if (node.mesh != kNone) {
      add_mesh_of(shown);
    }
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end()) {
      add_light(light->second.Get("light").GetNumberAsInt(), moved_by, T_world_node);
    }
    if (node.camera != kNone) {
      add_camera(node, moved_by, T_world_node);
    }
  }

  /// Adds a child of the instancing node for each instance of its mesh and returns their indices.
  std::vector<int> instance_nodes(int index) {
    const tinygltf::Node& node = model_.content.nodes[at(index)];
    const int parent = forest_.of_gltf[at(index)];
    std::vector<int> nodes;
    for (const Eigen::Affine3d& T_node_instance :
         read_instancing(reading_, node, model_.place("nodes", index))) {
      T_world_node_.push_back(T_world_node_[at(parent)] * T_node_instance);
      require(T_world_node_.back().matrix().allFinite(), model_.place("nodes", index),
              ": the transform of instance ", nodes.size(), " overflows, expected finite numbers");
      nodes.push_back(static_cast<int>(forest_.nodes.size()));
      forest_.nodes.push_back({.parent = parent, .T_parent_node = T_node_instance});
    }
    return nodes;
  }

  void add_mesh_of(const ShownMesh& shown) {
    const tinygltf::Node& node = shown.node;
    if (node.skin != kNone && is_instancing(node)) {
      add_note(reading_.notes, "instances of skinned meshes are left out");
    }
    if (node.skin != kNone || has_targets(node.mesh)) {
      add_bending(shown);
      return;
    }
    for (const auto& [mesh, primitive] : meshes_of(node.mesh)) {
      add_instance(mesh, primitive, shown);
    }
  }

  void add_instance(int mesh, int primitive, const ShownMesh& shown) {
    require(scene_.instances.size() < kMostInstances, model_.path.string(),
            ": has more instances of primitives than ", kMostInstances,
            ", expected at most as many");
    scene_.instances.push_back({mesh, T_world_node_[at(shown.stands_at)]});
    scene_.motion.instance_nodes.push_back(shown.stands_at);
    labels_.instances.push_back(shown.label);
    labels_.instances.back().primitive = primitive;
  }

  void require_room(const Scene& scene) const {
    const std::vector<bool> sharing = sharing_instances(scene);
    MemoryBudget budget;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < sharing.size(); ++i) {
      const std::size_t vertices = scene.meshes[at(scene.instances[i].mesh)].positions.size();
      sum += vertices;
      require(sum <= kMostPlacedVertices, model_.path.string(), ": its instances have more than ",
              kMostPlacedVertices, " vertices in all, expected at most as many");
      if (!sharing[i]) {
        budget.take(vertices * kPlacedVertexBytes, model_.path.string());
      }
    }
  }

  bool has_targets(int gltf_mesh) const {
    const auto& primitives = model_.content.meshes[at(gltf_mesh)].primitives;
    return std::any_of(primitives.begin(), primitives.end(),
                       [](const tinygltf::Primitive& p) { return !p.targets.empty(); });
  }

  std::string place_of(int gltf_mesh, std::size_t primitive) const {
    return model_.place("meshes", gltf_mesh) + ".primitives[" + std::to_string(primitive) + ']';
  }

  int add_mesh(Mesh mesh) {
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
  }

  /// Returns the scene's meshes of a glTF mesh's primitives, which are read on first use.
  const std::vector<PrimitiveMesh>& meshes_of(int gltf_mesh) {
    const auto [entry, is_new] = meshes_.try_emplace(gltf_mesh);
    if (is_new) {
      const auto& primitives = model_.content.meshes[at(gltf_mesh)].primitives;
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        auto geometry = read_primitive(reading_, primitives[i], place_of(gltf_mesh, i));
        if (geometry && !geometry->mesh.triangles.empty()) {
          geometry->mesh.material = materials_.material(primitives[i].material);
          entry->second.push_back({add_mesh(std::move(geometry->mesh)), static_cast<int>(i)});
        }
      }
    }
    return entry->second;
  }

  /// Adds a morphed or skinned mesh, a copy for each node, as each may deform differently.
  void add_bending(const ShownMesh& shown) {
    const tinygltf::Node& node = shown.node;
    const auto& primitives = model_.content.meshes[at(node.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      auto geometry = read_primitive(reading_, primitives[i], place_of(node.mesh, i));
      if (!geometry || geometry->mesh.triangles.empty()) {
        continue;
      }
      geometry->mesh.material = materials_.material(primitives[i].material);
      DeformableMesh deforming;
      deforming.instance = static_cast<int>(scene_.instances.size());
      deforming.node = shown.moved_by;
      deforming.skin = node.skin == kNone ? kNone : skin(node.skin);
      VertexJoints joints = joints_of(primitives[i], deforming.skin, place_of(node.mesh, i));
      if (joints.sets == 0) {
        deforming.skin = kNone;
      }
      const Mesh& mesh = geometry->mesh;
      deforming.shape = static_cast<int>(scene_.motion.shapes.size());
      scene_.motion.shapes.push_back({.positions = mesh.positions,
                                      .normals = mesh.normals,
                                      .tangents = mesh.tangents,
                                      .targets = std::move(geometry->targets),
                                      .followed = std::move(joints)});
      add_instance(add_mesh(std::move(geometry->mesh)), static_cast<int>(i), shown);
      scene_.motion.deforming.push_back(deforming);
    }
  }

  VertexJoints joints_of(const tinygltf::Primitive& primitive, int skin_index,
                         const std::string& place) {
    if (skin_index == kNone) {
      return {};
    }
    VertexJoints joints =
        read_joints(model_, primitive, scene_.motion.skins[at(skin_index)].joints.size(), place);
    if (joints.sets == 0) {
      add_note(reading_.notes, "meshes without joints and weights do not follow their skin");
    }
    return joints;
  }

  int skin(int gltf_index) {
    int& index = skins_[at(gltf_index)];
    if (index == kNone) {
      index = static_cast<int>(scene_.motion.skins.size());
      scene_.motion.skins.push_back(read_skin(model_, gltf_index, forest_));
    }
    return index;
  }

  void add_light(int index, int moved_by, const Eigen::Affine3d& T_world_light) {
    const tinygltf::Light& source = model_.content.lights[at(index)];
    if (source.type != "point" && source.type != "directional" && source.type != "spot") {
      add_note(reading_.notes, "lights of type " + source.type + " are left out");
      return;
    }
    const Light light = place_light(source, T_world_light, options_.scale);
    require(light.direction.squaredNorm() > 0, model_.path.string(),
            ": a light that has a direction is on a node of scale zero, expected a direction");
    require_within_world(Eigen::AlignedBox3d(light.position), model_.path.string() + ": a light");
    scene_.lights.push_back(light);
    shining_.lights.push_back(index);
    scene_.motion.light_nodes.push_back(moved_by);
  }

  void add_camera(const tinygltf::Node& node, int moved_by, const Eigen::Affine3d& T_world_node) {
    SceneCamera camera = place_camera(model_.content.cameras[at(node.camera)], T_world_node);
    if (camera.name.empty()) {
      camera.name = node.name;
    }
    scene_.cameras.push_back(camera);
    scene_.motion.camera_nodes.push_back(moved_by);
  }

  Scene at_rest() const {
    if (scene_.motion.deforming.empty()) {
      Scene scene = scene_;
      scene.motion = {};
      return scene;
    }
    try {
      return scene_at_rest(scene_);
    } catch (const vo::Error& error) {
      vo::fail(model_.path.string(), ": ", error.what());
    }
  }

  const GltfModel& model_;
  const GltfOptions& options_;
  MemoryBudget budget_;
  Scene scene_;
  GltfReading reading_;
  MaterialReader materials_;
  NodeForest forest_;
  std::vector<Eigen::Affine3d> T_world_node_;  ///< transform of each of forest_.nodes
  std::map<int, std::vector<PrimitiveMesh>> meshes_;
  std::vector<int> skins_;
  ShiningSources shining_;
  std::vector<bool> is_read_;  ///< whether each glTF mesh was read
  SceneLabels labels_;
};

/// Returns the index of the wanted scene; none if the file has no scenes and none is wanted.
std::optional<int> chosen_scene(const GltfModel& model, const std::string& wanted) {
  const std::vector<tinygltf::Scene>& scenes = model.content.scenes;
  if (wanted.empty()) {
    return scenes.empty() ? std::nullopt : std::optional(std::max(model.content.defaultScene, 0));
  }
  std::vector<std::string> names;
  for (const tinygltf::Scene& scene : scenes) {
    names.push_back(scene.name);
  }
  return select_one(wanted, names, "scene", model.path.string());
}

}  // namespace

LabelledScene read_scene(const GltfModel& model, const GltfOptions& options, Notes& notes) {
  LabelledScene labelled = SceneReader(model, options, notes).read();
  labelled.scene.environment =
      read_image_based_light(model, chosen_scene(model, options.scene), options, notes);
  if (labelled.scene.instances.empty()) {
    add_note(notes, "the scene has no triangles");
  }
  return labelled;
}

std::vector<int> scene_nodes(const GltfModel& model, const std::string& wanted) {
  const std::optional<int> chosen = chosen_scene(model, wanted);
  return nodes_below(model.content,
                     chosen ? model.content.scenes[at(*chosen)].nodes : root_nodes(model.content));
}

}  // namespace synth
