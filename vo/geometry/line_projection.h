#pragma once

#include "vo/geometry/camera.h"
#include "vo/geometry/readout.h"

namespace vo {

/// The focal length and the centre, px, across the lines of an image, and its inverse size, 1/px.
struct LineProjection {
  float focal, centre, inverse_size;

  LineProjection(const PinholeCamera& camera, ReadoutAxis axis)
      : focal(static_cast<float>(axis == ReadoutAxis::rows ? camera.fy : camera.fx)),
        centre(static_cast<float>(axis == ReadoutAxis::rows ? camera.cy : camera.cx)),
        inverse_size(
            1 / static_cast<float>(axis == ReadoutAxis::rows ? camera.height : camera.width)) {}

  /// Returns how far past the middle line a ray's slope is seen, as a share of the image's size.
  EDVO_INLINE float past_middle(float slope) const {
    return vo::past_middle(focal * slope + centre, inverse_size);
  }
};

}  // namespace vo
