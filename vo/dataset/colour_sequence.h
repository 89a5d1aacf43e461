#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/files/output.h"
#include "vo/geometry/camera_model.h"

namespace vo {

/// Encodes the file of a frame of a sequence without depth, rgb/000000.png: such a sequence is
/// rgb/, rgb.txt and camera.toml of TUM's layout, which `SequenceReader` reads as
/// SequenceContent::colour.
std::vector<NamedBytes> encode_colour_frame(std::size_t index, const RgbdFrame& frame);

/// Encodes the list of the images and camera.toml for frames of these stamps, s.
std::vector<NamedBytes> encode_colour_lists(const RgbdCameraModel& camera,
                                            const std::vector<double>& timestamps);

/// Returns a list of TUM's layout, with a line for each stamp, s, and `frame_file` of its index.
std::string format_image_list(const std::string& title, const char* folder, const char* extension,
                              const std::vector<double>& timestamps);

}  // namespace vo
