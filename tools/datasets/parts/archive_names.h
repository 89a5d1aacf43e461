#pragma once

#include <string>

namespace tools {

/// Returns the name that a frame's file has in an archive, as WebDataset groups files: all of one
/// frame have the name up to the first dot, SEQUENCE/000012, and what they are behind it.
/// `rgb/000012.png` becomes `SEQUENCE/000012.rgb.png`, `truth/flow/000012.flo`
/// `SEQUENCE/000012.flow.flo`. With the name of a camera of a rig, whose cameras' frames of one
/// number are one sample, it is `SEQUENCE/000012.CAMERA.rgb.png`.
std::string archive_name(const std::string& sequence, const std::string& camera,
                         const std::string& file);

}  // namespace tools
