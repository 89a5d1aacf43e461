#pragma once

#include <vector>

#include <Eigen/Core>

#include "synth/scene/scene.h"

namespace synth {

/// Returns the vertices, m, world, of all instances, or at most 2^20 spread evenly over them.
std::vector<Eigen::Vector3d> sample_vertices(const Scene& scene);

}  // namespace synth
