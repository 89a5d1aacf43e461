#include "synth/gltf/actors.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "synth/gltf_document/notes.h"
#include "synth/scene/scene_motion.h"
#include "vo/core/error.h"

namespace synth {
namespace {

template <typename Element>
void append(std::vector<Element>& to, std::vector<Element>& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

template <typename Element>
int size_of(const std::vector<Element>& elements) {
  return static_cast<int>(elements.size());
}

/// Adds `by` to an index unless it is none.
void shift(int& index, int by) {
  index += index == kNone ? 0 : by;
}

/// Makes an actor's materials refer to its textures where these stand in the world.
void shift_textures(int by, Material& material) {
  for (TextureSlot* slot : all_texture_slots(material)) {
    shift(slot->texture, by);
  }
}

/// Makes an actor's motion refer to its nodes and instances where these stand in the world. Its
/// roots become children of `root`.
void shift_motion(const SceneMotion& world, int instances, int root, SceneMotion& motion) {
  const int nodes = size_of(world.nodes);
  for (MotionNode& node : motion.nodes) {
    node.parent = node.parent == kNone ? root : node.parent + nodes;
  }
  for (Animation& animation : motion.animations) {
    for (AnimationChannel& channel : animation.channels) {
      channel.node += nodes;
    }
  }
  for (std::vector<int>* users : {&motion.instance_nodes, &motion.light_nodes}) {
    for (int& node : *users) {
      node += nodes;
    }
  }
  for (Skin& skin : motion.skins) {
    for (int& joint : skin.joints) {
      joint += nodes;
    }
  }
  for (DeformableMesh& mesh : motion.deforming) {
    mesh.instance += instances;
    mesh.shape += size_of(world.shapes);
    mesh.node += nodes;
    shift(mesh.skin, size_of(world.skins));
  }
}

bool states_brightness(const SceneMotion& motion) {
  return !motion.light_brightness.empty() || !motion.emission.empty();
}

/// States how bright each light and surface of a scene is, also where no animation changes it.
void complete_brightness(Scene& scene) {
  if (states_brightness(scene.motion)) {
    return;
  }
  for (const Light& light : scene.lights) {
    scene.motion.light_brightness.push_back({.color = light.intensity});
  }
  for (const Material& material : scene.materials) {
    scene.motion.emission.push_back({.color = material.emission});
  }
}

/// Lets an actor's animations change its own lights and materials where these stand in the world.
void append_brightness(Scene& actor, Scene& world) {
  if (!states_brightness(actor.motion) && !states_brightness(world.motion)) {
    return;
  }
  complete_brightness(actor);
  complete_brightness(world);
  for (Animation& animation : actor.motion.animations) {
    for (BrightnessChannel& channel : animation.brightness) {
      channel.target += channel.is_of_light() ? size_of(world.lights) : size_of(world.materials);
    }
  }
  append(world.motion.light_brightness, actor.motion.light_brightness);
  append(world.motion.emission, actor.motion.emission);
}

void append_motion(SceneMotion& motion, SceneMotion& world) {
  append(world.nodes, motion.nodes);
  append(world.animations, motion.animations);
  append(world.instance_nodes, motion.instance_nodes);
  append(world.light_nodes, motion.light_nodes);
  append(world.shapes, motion.shapes);
  append(world.skins, motion.skins);
  append(world.deforming, motion.deforming);
}

/// Lets an actor's own animations play while it goes.
void time_animations(const ActorOptions& options, const Animation& walk, SceneMotion& motion) {
  for (Animation& animation : motion.animations) {
    animation.start = walk.start;
    animation.loops = true;
    if (!options.loop) {
      animation.stop = walk.start + walk.duration;
    }
  }
}

void append_scene(const ActorOptions& options, Scene& actor, Scene& world) {
  for (Mesh& mesh : actor.meshes) {
    shift(mesh.material, size_of(world.materials));
  }
  for (Instance& instance : actor.instances) {
    shift(instance.mesh, size_of(world.meshes));
  }
  for (Material& material : actor.materials) {
    shift_textures(size_of(world.textures), material);
  }
  for (Texture& texture : actor.textures) {
    shift(texture.image, size_of(world.images));
  }
  const int root = size_of(world.motion.nodes);
  const Animation walk = walk_of(options, root);
  world.motion.nodes.emplace_back();
  time_animations(options, walk, actor.motion);
  shift_motion(world.motion, size_of(world.instances), root, actor.motion);
  append_brightness(actor, world);
  append_motion(actor.motion, world.motion);
  world.motion.animations.push_back(walk);
  append(world.meshes, actor.meshes);
  append(world.instances, actor.instances);
  append(world.materials, actor.materials);
  append(world.textures, actor.textures);
  append(world.images, actor.images);
  append(world.lights, actor.lights);
}

void append_labels(SceneLabels& actor, SceneLabels& world) {
  const int file = size_of(world.files);
  for (InstanceLabel& label : actor.instances) {
    label.file = file;
  }
  for (MaterialLabel& label : actor.materials) {
    label.file = file;
  }
  append(world.files, actor.files);
  append(world.instances, actor.instances);
  append(world.materials, actor.materials);
}

bool is_skinned(const SceneMotion& motion) {
  return std::any_of(motion.deforming.begin(), motion.deforming.end(),
                     [](const DeformableMesh& mesh) { return mesh.skin != kNone; });
}

LabelledScene load_actor(const ActorOptions& options, NeededTextures needed, Notes* notes) {
  options.validate();
  Notes own;
  LabelledScene actor = load_with_nodes(
      options.file, {.animation = options.animation, .scale = options.scale, .needed = needed},
      &own);
  vo::require(!options.skinned || is_skinned(actor.scene.motion), options.file.string(),
              ": has no mesh that a skin bends, expected one, as the actor is to be skinned");
  for (const std::string& note : own) {
    if (notes != nullptr) {
      add_note(*notes, vo::concat(options.file.filename().string(), ": ", note));
    }
  }
  return actor;
}

/// Returns the scene as it is at rest, with its motion.
Scene rested(Scene scene) {
  Scene rest = scene_at_rest(scene);
  rest.motion = std::move(scene.motion);
  return rest;
}

}  // namespace

LabelledScene load_with_actors(const std::filesystem::path& path, const GltfOptions& options,
                               const std::vector<ActorOptions>& actors, Notes* notes) {
  LabelledScene world = load_with_nodes(path, options, notes);
  for (Animation& animation : world.scene.motion.animations) {
    animation.loops = options.loop;
  }
  world.scene.motion.loop = false;  // each animation has its own say
  for (const ActorOptions& one : actors) {
    LabelledScene actor = load_actor(one, options.needed, notes);
    append_scene(one, actor.scene, world.scene);
    append_labels(actor.labels, world.labels);
  }
  world.scene = rested(std::move(world.scene));
  return world;
}

}  // namespace synth
