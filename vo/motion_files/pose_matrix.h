#pragma once

#include <filesystem>
#include <optional>

#include <Eigen/Core>

#include "vo/geometry/se3.h"

namespace vo {

/// Reads a file with the rows of a matrix, three or four of four numbers. It may hold inf and nan.
/// Throws Error naming file and line.
Eigen::Matrix4d read_matrix(const std::filesystem::path& path);

/// Reads T_world_camera from a file with its matrix, as 7-Scenes and ScanNet have one for each
/// frame. There is none where a value is inf or nan: the frame was not tracked. Throws Error naming
/// the file unless it is a rotation and a translation.
std::optional<SE3> read_pose_matrix(const std::filesystem::path& path);

}  // namespace vo
