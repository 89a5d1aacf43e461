#pragma once

#include "vo/core/image.h"

namespace vo {

/// Returns the stamp of a frame's depth, s, which may not be that of its image.
inline double depth_timestamp(const RgbdFrame& frame) {
  return frame.timestamp + frame.depth_delay;
}

}  // namespace vo
