#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "synth/scene/motion.h"
#include "synth/scene/scene.h"

namespace synth {

/// Gives the mesh the shape's vertices with its morph targets added, each times its weight; missing
/// weights are 0.
void morph(const MeshShape& shape, const std::vector<float>& weights, Mesh& mesh);

/// Moves each vertex by the weighted sum of its joints' transforms, which take the mesh's
/// coordinates to the frame the mesh shall stand in (linear blend skinning).
void deform(const VertexJoints& followed, const std::vector<Eigen::Affine3d>& T_frame_mesh,
            Mesh& mesh);

}  // namespace synth
