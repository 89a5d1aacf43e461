#pragma once

#include <cstddef>
#include <string>

#include <opencv2/core.hpp>

#include "synth/gltf_document/gltf_file.h"

namespace synth {

/// How many texels an encoded image says that it has. Throws what decode_image does.
std::size_t texels_in(const Bytes& encoded, const std::string& place);

/// Decodes a PNG or JPEG to 8-bit RGBA. Throws vo::Error beginning with `place` for other formats,
/// damaged data and sizes that no texture has.
cv::Mat_<cv::Vec4b> decode_image(const Bytes& encoded, const std::string& place);

}  // namespace synth
