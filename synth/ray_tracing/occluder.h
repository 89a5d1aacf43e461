#pragma once

#include <Eigen/Core>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/scene/world_geometry.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// A triangle that shadow rays are tested against, in the world-space geometry's coordinates.
struct Wall {
  Eigen::Vector3f a = Eigen::Vector3f::Zero();  ///< one corner, m
  Eigen::Vector3f ab = Eigen::Vector3f::Zero();
  Eigen::Vector3f ac = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< ab x ac
  float clearance = 0;  ///< m, least distance of a certain hit from both ends of a ray
};

/// A triangle that stopped shadow rays towards a light, and is likely to stop the next ones too.
class Occluder {
 public:
  Occluder() = default;
  Occluder(const WorldGeometry& world, const ShadowHit& hit);

  bool is(const ShadowHit& hit) const;

  /// Deactivates the rays that certainly hit the triangle, which Embree would find occluded, too.
  /// `reach` is in lengths of the rays' directions. Returns whether active rays are left.
  bool stop(ShadowPacket& packet, float reach, vo::InstructionSet set) const;

 private:
  ShadowHit hit_;
  Wall wall_;
  bool is_usable_ = false;  ///< does not move and is wide enough for certain hits
};

}  // namespace synth
