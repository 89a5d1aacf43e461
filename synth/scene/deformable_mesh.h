#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "synth/scene/motion.h"
#include "synth/scene/scene.h"

namespace synth {

/// Sets the mesh's positions, normals and tangents to the shape's plus its morph targets, each
/// times its weight; missing weights count as 0.
void morph(const MeshShape& shape, const std::vector<float>& weights, Mesh& mesh);

/// Applies linear blend skinning: transforms each vertex by the weighted sum of its joints'
/// transforms `T_frame_mesh`, from mesh coordinates to the frame of the skinned mesh.
void deform(const VertexJoints& followed, const std::vector<Eigen::Affine3d>& T_frame_mesh,
            Mesh& mesh);

}  // namespace synth
