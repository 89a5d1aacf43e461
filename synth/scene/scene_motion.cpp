#include "synth/scene/scene_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "synth/scene/deformable_mesh.h"
#include "synth/scene/placed.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Frames = std::vector<Eigen::Affine3d>;  // T_world_node of each node

/// The nodes that animations change, by index, as they are at one time.
struct Poses {
  std::map<int, MotionNode> nodes;
};

double time_within(const Animation& animation, double time, bool loop) {
  const double played = std::min(time, animation.stop) - animation.start;
  return (loop || animation.loops) && animation.duration > 0
             ? std::fmod(std::max(played, 0.0), animation.duration)
             : played;
}

void apply(const AnimationChannel& channel, double time, MotionNode& node) {
  const std::vector<double> value = value_at(channel.curve, time);
  switch (channel.property) {
    case AnimatedProperty::translation:
      node.translation = Eigen::Map<const Eigen::Vector3d>(value.data());
      break;
    case AnimatedProperty::rotation:
      node.rotation = Eigen::Map<const Eigen::Quaterniond>(value.data());
      break;
    case AnimatedProperty::scale:
      node.scale = Eigen::Map<const Eigen::Vector3d>(value.data());
      break;
    case AnimatedProperty::weights:
      node.weights.assign(value.begin(), value.end());
      return;
  }
  node.T_parent_node =
      Eigen::Translation3d(node.translation) * node.rotation * Eigen::Scaling(node.scale);
}

Poses poses_at(const SceneMotion& motion, double time) {
  Poses poses;
  for (const Animation& animation : motion.animations) {
    const double within = time_within(animation, time, motion.loop);
    for (const AnimationChannel& channel : animation.channels) {
      const auto entry =
          poses.nodes.try_emplace(channel.node, motion.nodes[at(channel.node)]).first;
      apply(channel, within, entry->second);
    }
  }
  return poses;
}

const MotionNode& node_in(const SceneMotion& motion, const Poses& poses, int node) {
  const auto changed = poses.nodes.find(node);
  return changed == poses.nodes.end() ? motion.nodes[at(node)] : changed->second;
}

Frames place_nodes(const SceneMotion& motion, const Poses& poses) {
  Frames frames;
  frames.reserve(motion.nodes.size());
  for (std::size_t i = 0; i < motion.nodes.size(); ++i) {
    const MotionNode& node = node_in(motion, poses, static_cast<int>(i));
    frames.push_back(node.parent == kNone ? node.T_parent_node
                                          : frames[at(node.parent)] * node.T_parent_node);
    vo::require(frames.back().matrix().allFinite(), "node ", i,
                " of the moving scene: its transform overflows, expected finite numbers");
  }
  return frames;
}

Brightness changed(Brightness brightness, bool is_color, const std::vector<double>& value) {
  const auto factor = [&](std::size_t i) { return static_cast<float>(std::max(0.0, value[i])); };
  if (is_color) {
    brightness.color = {factor(0), factor(1), factor(2)};
  } else {
    brightness.strength = factor(0);
  }
  return brightness;
}

/// Makes lights and surfaces as bright as the animations say; a channel of each factor of one may
/// come after the other.
void set_brightness(const SceneMotion& motion, double time, Scene& scene) {
  std::vector<Brightness> lights = motion.light_brightness;
  std::vector<Brightness> emission = motion.emission;
  for (const Animation& animation : motion.animations) {
    const double within = time_within(animation, time, motion.loop);
    for (const BrightnessChannel& channel : animation.brightness) {
      const std::size_t target = at(channel.target);
      Brightness& brightness = channel.is_of_light() ? lights[target] : emission[target];
      brightness = changed(brightness, channel.is_color(), value_at(channel.curve, within));
      (channel.is_of_light() ? scene.lights[target].intensity : scene.materials[target].emission) =
          brightness.color * brightness.strength;
    }
  }
}

bool changes_brightness(const SceneMotion& motion) {
  return std::any_of(
      motion.animations.begin(), motion.animations.end(), [](const Animation& animation) {
        return std::any_of(
            animation.brightness.begin(), animation.brightness.end(),
            [](const BrightnessChannel& channel) { return !is_constant(channel.curve); });
      });
}

/// Skins a mesh and places its instance at the first joint, so that its coordinates stay small.
void follow_joints(const SceneMotion& motion, const DeformableMesh& deforming, const Frames& frames,
                   Scene& scene) {
  const Skin& skin = motion.skins[at(deforming.skin)];
  const Eigen::Vector3d origin = frames[at(skin.joints.front())].translation();
  Frames T_frame_mesh;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    T_frame_mesh.push_back(Eigen::Translation3d(-origin) * frames[at(skin.joints[i])] *
                           skin.T_joint_mesh[i]);
  }
  Instance& instance = scene.instances[at(deforming.instance)];
  instance.T_world_mesh = Eigen::Translation3d(origin);
  deform(motion.shapes[at(deforming.shape)].followed, T_frame_mesh,
         scene.meshes[at(instance.mesh)]);
}

void place_all(const SceneMotion& motion, const Poses& poses, Scene& scene) {
  const Frames frames = place_nodes(motion, poses);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    scene.instances[i].T_world_mesh = frames[at(motion.instance_nodes[i])];
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Eigen::Affine3d& T_world_light = frames[at(motion.light_nodes[i])];
    scene.lights[i].position = T_world_light.translation();
    const Eigen::Vector3d direction = light_direction_of(T_world_light);
    if (scene.lights[i].kind != LightKind::point && direction.squaredNorm() > 0) {
      scene.lights[i].direction = direction;
    }
  }
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    scene.cameras[i].T_world_camera = T_world_camera_of(frames[at(motion.camera_nodes[i])]);
  }
  for (const DeformableMesh& deforming : motion.deforming) {
    Mesh& mesh = scene.meshes[at(scene.instances[at(deforming.instance)].mesh)];
    morph(motion.shapes[at(deforming.shape)], node_in(motion, poses, deforming.node).weights, mesh);
    if (deforming.skin != kNone) {
      follow_joints(motion, deforming, frames, scene);
    }
    for (const Eigen::Vector3f& position : mesh.positions) {
      vo::require(position.allFinite(), "the mesh of instance ", deforming.instance,
                  ": a vertex overflows as it bends, expected finite numbers");
    }
  }
}

struct MovingNodes {
  std::vector<bool> frames, weights;
};

MovingNodes moving_nodes(const SceneMotion& motion) {
  MovingNodes moving{std::vector<bool>(motion.nodes.size(), false),
                     std::vector<bool>(motion.nodes.size(), false)};
  for (const Animation& animation : motion.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (!is_constant(channel.curve)) {
        const bool deforms = channel.property == AnimatedProperty::weights;
        (deforms ? moving.weights : moving.frames)[at(channel.node)] = true;
      }
    }
  }
  for (std::size_t i = 0; i < motion.nodes.size(); ++i) {
    const int parent = motion.nodes[i].parent;
    moving.frames[i] = moving.frames[i] || (parent != kNone && moving.frames[at(parent)]);
  }
  return moving;
}

bool any_moves(const SceneMotion& motion, const std::vector<int>& nodes) {
  const MovingNodes moving = moving_nodes(motion);
  return std::any_of(nodes.begin(), nodes.end(), [&](int node) { return moving.frames[at(node)]; });
}

Scene without_motion(const Scene& scene) {
  return {.meshes = scene.meshes,
          .instances = scene.instances,
          .materials = scene.materials,
          .textures = scene.textures,
          .images = scene.images,
          .lights = scene.lights,
          .cameras = scene.cameras,
          .environment = scene.environment};
}

}  // namespace

double scene_time(const vo::Trajectory& truth, double timestamp) {
  return timestamp - truth.front().timestamp;
}

Scene scene_at(const Scene& scene, double time) {
  Scene at_time = without_motion(scene);
  if (!scene.motion.animations.empty()) {
    place_all(scene.motion, poses_at(scene.motion, time), at_time);
    set_brightness(scene.motion, time, at_time);
  }
  return at_time;
}

SceneDuring scene_during(const Scene& scene, double now, double begin, double end) {
  constexpr int kIntervals = 8;
  SceneDuring during{.now = scene_at(scene, now), .begin = begin, .end = end};
  for (int i = 0; end > begin && i <= kIntervals; ++i) {
    during.moments.push_back(scene_at(scene, begin + (end - begin) * i / kIntervals));
  }
  return during;
}

Scene scene_at_rest(const Scene& scene) {
  Scene at_rest = without_motion(scene);
  if (!scene.motion.nodes.empty()) {
    place_all(scene.motion, {}, at_rest);
  }
  return at_rest;
}

bool moves(const Scene& scene) {
  const std::vector<bool> instances = moving_instances(scene);
  return std::find(instances.begin(), instances.end(), true) != instances.end() ||
         any_moves(scene.motion, scene.motion.light_nodes) || changes_brightness(scene.motion);
}

bool moves_cameras(const Scene& scene) {
  return any_moves(scene.motion, scene.motion.camera_nodes);
}

std::vector<bool> moving_instances(const Scene& scene) {
  const SceneMotion& motion = scene.motion;
  const MovingNodes nodes = moving_nodes(motion);
  std::vector<bool> moving(scene.instances.size(), false);
  for (std::size_t i = 0; i < motion.instance_nodes.size(); ++i) {
    moving[i] = nodes.frames[at(motion.instance_nodes[i])];
  }
  for (const DeformableMesh& deforming : motion.deforming) {
    bool deforms = nodes.weights[at(deforming.node)];
    if (deforming.skin != kNone) {  // a skinned mesh ignores its own node's transform
      const std::vector<int>& joints = motion.skins[at(deforming.skin)].joints;
      deforms = deforms || std::any_of(joints.begin(), joints.end(),
                                       [&](int joint) { return nodes.frames[at(joint)]; });
      moving[at(deforming.instance)] = deforms;
    } else {
      moving[at(deforming.instance)] = moving[at(deforming.instance)] || deforms;
    }
  }
  return moving;
}

}  // namespace synth
