#pragma once

#include <Eigen/Core>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/scene/world_geometry.h"
#include "vo/core/instruction_set.h"

namespace synth {

/// A triangle that rays are tested against.
struct Wall {
  Eigen::Vector3f a = Eigen::Vector3f::Zero();  ///< a corner, m
  Eigen::Vector3f ab = Eigen::Vector3f::Zero();
  Eigen::Vector3f ac = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< ab x ac
  float clearance = 0;  ///< m, that a doubtless hit keeps from both ends of a ray
};

/// A triangle that stood between surfaces and a light, and is likely to be in the way of the next
/// rays too.
class Occluder {
 public:
  Occluder() = default;
  Occluder(const WorldGeometry& world, const ShadowHit& hit);

  bool is(const ShadowHit& hit) const;

  /// Takes the rays that it stops beyond doubt out of the packet: those that Embree would find
  /// stopped. `reach` is in lengths of their directions. Returns whether rays are left.
  bool stop(ShadowPacket& packet, float reach, vo::InstructionSet set) const;

 private:
  ShadowHit hit_;
  Wall wall_;
  bool is_usable_ = false;  ///< at rest, and wide enough for doubtless hits
};

}  // namespace synth
