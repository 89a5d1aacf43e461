#pragma once

#include <cstddef>
#include <string>

#include <opencv2/core.hpp>

#include "synth/gltf_document/gltf_file.h"

namespace synth {

/// Returns the number of texels that an encoded image states in its header. Throws vo::Error
/// beginning with `place` for formats other than PNG and JPEG, and for 0 or over 2^26 texels.
std::size_t texels_in(const Bytes& encoded, const std::string& place);

/// Decodes a PNG or JPEG to 8-bit RGBA. Throws vo::Error beginning with `place` for other formats,
/// damaged data, and 0 or over 2^26 texels.
cv::Mat_<cv::Vec4b> decode_image(const Bytes& encoded, const std::string& place);

}  // namespace synth
