#pragma once

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/image/vignette.h"

namespace vo {

/// Scales an image's grey values from 0..255 to 0..1 and removes the vignette from them, in one
/// pass. The memory of `gray` is reused if nobody else holds it.
void to_gray_without(const Vignette& vignette, const PinholeCamera& camera, const ByteImage& bytes,
                     GrayImage& gray);

}  // namespace vo
