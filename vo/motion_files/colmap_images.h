#pragma once

#include <string>
#include <vector>

#include "vo/geometry/trajectory.h"
#include "vo/motion_files/frame_times.h"
#include "vo/text_files/text_lines.h"

namespace vo {

/// Reads COLMAP's images.txt: two lines for each image, `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID
/// NAME` of T_camera_world and its points `X Y POINT3D_ID ...`, of which there may be none. The
/// images are in any order. A stamp is what `times`, unless null, has for the image's file, or in a
/// list without files for the frame (from 0) that the name ends with; without `times` the name ends
/// with the stamp, in s with a decimal point or in ns with 19 digits. Throws Error naming file and
/// line; appends to `notes`.
Trajectory read_colmap_images(const TextFile& file, const FrameTimes* times,
                              std::vector<std::string>& notes);

}  // namespace vo
