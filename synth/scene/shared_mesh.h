#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/scene.h"

namespace synth {

/// The vertices of a mesh that many instances show, kept once for all of them.
struct SharedMesh {
  const Mesh* mesh = nullptr;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m, of its box, in the mesh's frame
  /// m, the mesh's axes, from the centre, which keeps their precision; and one more: Embree reads
  /// 16 bytes at each.
  std::vector<Eigen::Vector3f> positions;
};

SharedMesh shared_mesh(const Mesh& mesh);

/// For each instance, whether it shows a shared mesh: one whose copies would hold many triangles.
/// `moments` are of the same scene meanwhile, if it moves. Instances that are sheared, flat, tiny
/// or huge at one of them keep vertices of their own: a ray that is taken to the mesh's frame in
/// single precision goes astray there.
std::vector<bool> sharing_instances(const Scene& scene, const std::vector<Scene>& moments = {});

}  // namespace synth
