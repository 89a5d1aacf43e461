#pragma once

#include <vector>

#include "synth/scene/scene.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// The time of a scene's animations, s, at a timestamp of a sequence: they start with its first
/// pose.
double scene_time(const vo::Trajectory& truth, double timestamp);

/// What a scene is at a time, s, as a scene without motion: nodes, skins, morph targets, lights and
/// cameras where its animations put them. Meshes, instances and triangles are the same, in the same
/// order, at all times: (instance, triangle, barycentric coordinates) is a point of the surface
/// that can be found again. Before an animation's first key and after its last, things keep those
/// keys' values, as glTF says; with SceneMotion::loop each animation starts again when its last key
/// is reached. Throws vo::Error where a transform overflows.
Scene scene_at(const Scene& scene, double time);

/// A scene around an instant of its animations.
struct SceneDuring {
  Scene now;                   ///< at the instant
  std::vector<Scene> moments;  ///< evenly spread from `begin` to `end`; empty: it rests
  double begin = 0;            ///< s
  double end = 0;              ///< s
};

/// Nine moments; one scene alone where begin and end are the same.
SceneDuring scene_during(const Scene& scene, double now, double begin, double end);

/// The same as its file puts it while no animation plays.
Scene scene_at_rest(const Scene& scene);

/// Whether an animation plays that anything visible follows: an instance or a light.
bool moves(const Scene& scene);

/// Whether an animation moves one of its cameras.
bool moves_cameras(const Scene& scene);

/// For each instance, whether an animation moves or deforms it.
std::vector<bool> moving_instances(const Scene& scene);

}  // namespace synth
