#pragma once

#include <filesystem>
#include <optional>

#include "vo/dataset/sequence_source.h"

namespace vo {

/// Opens a folder as Open3D's reconstruction system takes it, which is Redwood's layout (Choi et
/// al., CVPR 2015), too: images in color/, rgb/ or image/, depth (16 bit, mm) in depth/, and, if
/// they are there, camera_intrinsic.json or intrinsic.json and one trajectory *.log of
/// T_world_camera. Images and depth belong together in the order of the numbers that their names
/// end with; frames are 1 / 30 s apart. Names with stamps, FRAME-MICROSECONDS as Redwood's scans
/// have, or seconds with a point as TUM's, are paired by nearest stamp within 0.02 s. The camera is
/// `camera`, else that of camera.toml, which is this project's addition, else the file's, else
/// PrimeSense's defaults, with a note.
SequenceSource open_open3d(const std::filesystem::path& folder,
                           const std::optional<RgbdCamera>& camera);

/// Returns the folder of colour images within a folder that has one and one of depth; empty
/// otherwise.
std::filesystem::path open3d_images(const std::filesystem::path& folder);

}  // namespace vo
