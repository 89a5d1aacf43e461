#pragma once

#include <vector>

#include "synth/scene/scene.h"
#include "vo/geometry/trajectory.h"

namespace synth {

/// Returns the time of a scene's animations, s, at a timestamp of a sequence: the animations start
/// at the first pose of the true trajectory.
double scene_time(const vo::Trajectory& truth, double timestamp);

/// Returns the static scene at a time in s, with nodes, skins, morph targets, lights and cameras as
/// its animations place them, and what shines as bright as they make it. Meshes, instances and
/// triangles keep their order at all times, so that (instance, triangle, barycentric coordinates)
/// identifies a surface point. Before an animation's first key and after its last, values stay
/// those of that key, as in glTF; with SceneMotion::loop each animation restarts at its last key.
/// Throws vo::Error if a transform or vertex overflows.
Scene scene_at(const Scene& scene, double time);

/// The states of a scene around one instant of its animations.
struct SceneDuring {
  Scene now;                   ///< the scene at the instant
  std::vector<Scene> moments;  ///< evenly spaced from `begin` to `end`; empty if they are equal
  double begin = 0;            ///< s, animation time
  double end = 0;              ///< s, animation time
};

/// Returns the scene at `now` and at nine moments from `begin` to `end`, animation times in s;
/// without moments if `end` is not after `begin`.
SceneDuring scene_during(const Scene& scene, double now, double begin, double end);

/// Returns the static scene as its file places it while no animation plays.
Scene scene_at_rest(const Scene& scene);

/// Returns whether an animation changes anything visible: moves or deforms an instance, moves a
/// light, or changes how bright a light or a surface is.
bool moves(const Scene& scene);

/// Returns whether an animation moves one of the scene's cameras.
bool moves_cameras(const Scene& scene);

/// Returns for each instance whether an animation moves or deforms it.
std::vector<bool> moving_instances(const Scene& scene);

}  // namespace synth
