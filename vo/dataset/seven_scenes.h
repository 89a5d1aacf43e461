#pragma once

#include <filesystem>
#include <optional>

#include "vo/dataset/sequence_source.h"

namespace vo {

/// Opens a sequence of Microsoft's 7-Scenes (Shotton et al., CVPR 2013): frame-000000.color.png,
/// frame-000000.depth.png (16 bit, mm, 65535 is none) and frame-000000.pose.txt (the matrix of
/// T_world_camera), which may be absent. Frames are 1 / 30 s apart and have no stamps. The camera
/// is `camera`, else that of camera.toml, which is this project's addition, else the preset
/// 7-scenes. The data set's depth is not registered to its colour, a few px apart.
SequenceSource open_seven_scenes(const std::filesystem::path& folder,
                                 const std::optional<RgbdCamera>& camera);

/// Returns whether a folder holds an image of such a sequence.
bool holds_seven_scenes(const std::filesystem::path& folder);

}  // namespace vo
