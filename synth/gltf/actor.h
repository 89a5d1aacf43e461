#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synth/scene/animation.h"

namespace synth {

/// Something that goes through a scene: the scene of a glTF file of its own, which stands on y = 0
/// around its origin and faces +z, as glTF has it.
struct ActorOptions {
  std::filesystem::path file;
  std::string animation;  ///< that it plays while it goes, as GltfOptions::animation
  bool skinned = false;   ///< whether the file must have a skin that bends one of its meshes
  std::vector<Eigen::Vector3d> path;  ///< m, world: way points, at least two
  double speed = 1;                   ///< m/s along the path
  double start = 0;                   ///< s, scene time at which it sets out from the first point
  double turn_time = 0.5;             ///< s, that it takes to turn at a way point
  bool loop = false;                  ///< goes on from the last way point to the first, for ever
  double scale = 1;                   ///< factor of all its lengths

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, ActorOptions& options) {
  visit("file", options.file, "glTF file of what goes through the scene, facing +z");
  visit("animation", options.animation, "animation that it plays, name or number, or none [all]");
  visit("skinned", options.skinned, "whether a skin must bend it");
  visit("path", options.path, "way points [[x, y, z], ...], m, world");
  visit("speed", options.speed, "m/s along the path");
  visit("start", options.start, "s, when it sets out");
  visit("turn_time", options.turn_time, "s to turn at a way point");
  visit("loop", options.loop, "goes on from the last way point to the first, for ever");
  visit("scale", options.scale, "factor of all its lengths");
}

/// Returns the animation of a node that walks an actor's path at its speed, from `start` on, by
/// linear interpolation between the way points; it turns about y towards the next one, from half
/// the turn's time before a way point to half of it behind.
Animation walk_of(const ActorOptions& options, int node);

}  // namespace synth
