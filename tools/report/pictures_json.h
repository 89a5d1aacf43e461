#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include "tools/pictures/frame_pictures.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Returns the number rounded to 1e-6, which suffices for display; null where it is not finite.
nlohmann::ordered_json rounded(double value);

/// Returns a camera as `Camera` of web/src/data.ts declares it.
nlohmann::ordered_json camera_json(const vo::PinholeCamera& camera);

/// Returns the pictures of the frame of this index as `Pictures` of web/src/data.ts declares them.
nlohmann::ordered_json pictures_json(const FramePictures& pictures, std::size_t frame);

}  // namespace tools
