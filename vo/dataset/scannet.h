#pragma once

#include <filesystem>
#include <optional>

#include "vo/dataset/sequence_source.h"

namespace vo {

/// Opens a scan of ScanNet (Dai et al., CVPR 2017) as its SensReader exports it: color/0.jpg,
/// depth/0.png (16 bit, mm), pose/0.txt (the matrix of T_world_camera, -inf where tracking was
/// lost) and intrinsic/intrinsic_{color,depth}.txt. The frames are the depth camera's: colour of
/// another size is brought into it, as both share their centre; colour of depth's size is taken as
/// it is. Frames are 1 / 30 s apart and have no stamps. `camera`, else that of camera.toml, which
/// is this project's addition, takes precedence over intrinsic_depth.txt.
SequenceSource open_scannet(const std::filesystem::path& folder,
                            const std::optional<RgbdCamera>& camera);

}  // namespace vo
