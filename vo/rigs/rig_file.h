#pragma once

#include <filesystem>
#include <string>

#include "vo/rigs/rig.h"

namespace vo {

/// The file in the folder of a rig that says what its cameras are.
inline constexpr const char* kRigFile = "rig.toml";

/// Returns whether a folder is that of a rig.
bool is_rig(const std::filesystem::path& folder);

/// Reads a rig: a table [[camera]] for each camera, with `name`, the values of a camera.toml, its
/// `projection` among them, `time_offset`, `stereo`, `spectrum`, `scene_light` and [camera.sensor],
/// a table [[projector]] for each projector, 16 at most, and a table [imu]. A pose is
/// `T_body_camera`
/// (`T_body_projector`, `T_body_imu`), four rows of a matrix, or `position`, m, and `orientation`,
/// a quaternion x, y, z, w; without any of these it is the identity. Throws Error, which names file
/// and camera or projector, for what is missing, unknown, out of range or there twice, and for
/// stereo pairs that are not rectified. The files of patterns are not read.
Rig read_rig(const std::filesystem::path& path);

/// Returns a rig as TOML that `read_rig` reads. Poses are matrices.
std::string format_rig(const Rig& rig);

}  // namespace vo
