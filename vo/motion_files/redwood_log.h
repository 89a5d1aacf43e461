#pragma once

#include <filesystem>
#include <vector>

#include "vo/geometry/trajectory.h"

namespace vo {

/// Reads a trajectory as Redwood and Open3D write it: for each pose a line of three whole numbers,
/// of which the first is the frame's index, and the four rows of T_world_camera. Stamps are those
/// of the frames. Throws Error naming file and line: what is no such number or matrix, and frames
/// that do not follow each other or do not exist.
Trajectory read_redwood_log(const std::filesystem::path& path,
                            const std::vector<double>& timestamps);

}  // namespace vo
