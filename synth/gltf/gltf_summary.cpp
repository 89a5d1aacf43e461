#include "synth/gltf/gltf_summary.h"

#include <algorithm>

#include "synth/gltf/gltf_scene.h"
#include "synth/gltf_model/accessor.h"
#include "synth/gltf_model/gltf_reading.h"
#include "synth/gltf_model/nodes.h"
#include "synth/scene/scene_motion.h"
#include "synth/scene/shared_mesh.h"

namespace synth {
namespace {

int position_of(const tinygltf::Primitive& primitive) {
  const auto found = primitive.attributes.find("POSITION");
  return found == primitive.attributes.end() ? kNone : found->second;
}

std::size_t triangles_of(int mode, std::size_t corners) {
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    return corners / 3;
  }
  return mode > TINYGLTF_MODE_TRIANGLES && corners > 2 ? corners - 2 : 0;
}

void count_primitives(const tinygltf::Model& model, GltfSummary& summary) {
  for (const tinygltf::Mesh& mesh : model.meshes) {
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      // All attributes of a primitive have equal counts.
      const std::size_t vertices =
          primitive.attributes.empty()
              ? 0
              : model.accessors[at(primitive.attributes.begin()->second)].count;
      const std::size_t corners =
          primitive.indices == kNone ? vertices : model.accessors[at(primitive.indices)].count;
      ++summary.draw_calls;
      summary.vertices += vertices;
      summary.triangles += triangles_of(primitive.mode, corners);
    }
  }
}

Eigen::AlignedBox3d node_bounds(const GltfModel& model, const GltfOptions& options) {
  const NodeForest forest = read_nodes(model.content, options.scale);
  std::vector<Eigen::Affine3d> T_world_node;
  for (const MotionNode& node : forest.nodes) {
    T_world_node.push_back(node.parent == kNone
                               ? node.T_parent_node
                               : T_world_node[at(node.parent)] * node.T_parent_node);
  }
  Eigen::AlignedBox3d box;
  MemoryBudget budget;  // bounds the time that nodes which share a mesh may take
  for (const int index : scene_nodes(model, options.scene)) {
    const int mesh = model.content.nodes[at(index)].mesh;
    if (mesh == kNone) {
      continue;
    }
    for (const tinygltf::Primitive& primitive : model.content.meshes[at(mesh)].primitives) {
      const int position = position_of(primitive);
      if (position == kNone) {
        continue;
      }
      const std::string place = model.place("meshes", mesh) + ": POSITION";
      budget.take(model.content.accessors[at(position)].count * sizeof(Eigen::Vector3f), place);
      const auto positions = read_vectors<Eigen::Vector3f>(model.content, position, place);
      for (const Eigen::Vector3f& p_mesh : positions) {
        box.extend(T_world_node[at(forest.of_gltf[at(index)])] * p_mesh.cast<double>());
      }
    }
  }
  return box;
}

Eigen::AlignedBox3d bounds_of(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Instance& instance : scene.instances) {
    for (const Eigen::Vector3f& p_mesh : scene.meshes[at(instance.mesh)].positions) {
      box.extend(instance.T_world_mesh * p_mesh.cast<double>());
    }
  }
  return box;
}

std::size_t count_true(const std::vector<bool>& values) {
  return static_cast<std::size_t>(std::count(values.begin(), values.end(), true));
}

void count_instances(GltfSummary& summary) {
  summary.moving_instances = count_true(moving_instances(summary.scene));
  summary.sharing_instances = count_true(sharing_instances(summary.scene));
  for (const Instance& instance : summary.scene.instances) {
    summary.shown_triangles += summary.scene.meshes[at(instance.mesh)].triangles.size();
  }
}

/// Lists animations; the last key's time is the maximum that a sampler's input accessor must state.
std::vector<AnimationSummary> list_animations(const tinygltf::Model& model) {
  std::vector<AnimationSummary> animations;
  for (const tinygltf::Animation& source : model.animations) {
    AnimationSummary& summary = animations.emplace_back();
    summary.name = source.name;
    summary.channels = source.channels.size();
    for (const tinygltf::AnimationSampler& sampler : source.samplers) {
      const std::vector<double>& last = model.accessors[at(sampler.input)].maxValues;
      summary.duration = std::max(summary.duration, last.empty() ? 0 : last.front());
    }
  }
  return animations;
}

template <typename Element>
std::vector<std::string> names_of(const std::vector<Element>& elements) {
  std::vector<std::string> names;
  for (const Element& element : elements) {
    names.push_back(element.name);
  }
  return names;
}

}  // namespace

GltfSummary summarize_gltf(const std::filesystem::path& path, const GltfOptions& options) {
  GltfSummary summary;
  summary.scene = load_gltf(path, options, &summary.notes);
  const GltfModel model = read_gltf_model(read_gltf_file(path), summary.notes);
  count_primitives(model.content, summary);
  summary.bounds = node_bounds(model, options);
  summary.bounds_at_rest = bounds_of(summary.scene);
  summary.scenes = names_of(model.content.scenes);
  summary.materials = names_of(model.content.materials);
  summary.extensions_used = model.content.extensionsUsed;
  summary.extensions_required = model.content.extensionsRequired;
  summary.animations = list_animations(model.content);
  summary.nodes = model.content.nodes.size();
  summary.textures = model.content.textures.size();
  summary.images = model.content.images.size();
  summary.skins = model.content.skins.size();
  count_instances(summary);
  return summary;
}

}  // namespace synth
