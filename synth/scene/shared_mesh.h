#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/scene.h"

namespace synth {

/// The vertices of a mesh that many instances show, stored once for all of them.
struct SharedMesh {
  const Mesh* mesh = nullptr;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m, of the bounding box, mesh frame
  /// m, along the mesh's axes from `centre`, which preserves precision; padded by one element, as
  /// Embree reads 16 bytes at each position.
  std::vector<Eigen::Vector3f> positions;
};

SharedMesh shared_mesh(const Mesh& mesh);

/// Returns for each instance whether it shows a shared mesh: one whose copies would hold many
/// triangles. `moments` are the states of a moving scene. Instances that are sheared, flat, tiny or
/// huge at one of them keep vertices of their own, as transforming rays to their mesh's frame in
/// single precision would be inaccurate.
std::vector<bool> sharing_instances(const Scene& scene, const std::vector<Scene>& moments = {});

}  // namespace synth
