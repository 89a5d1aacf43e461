#pragma once

#include "vo/core/instruction_set.h"
#include "vo/geometry/lens.h"

namespace vo {

/// Calls `visit` with the distortion function (lens, x, y) of the lens's model, so that a loop in
/// it is compiled once per model and has no branch.
template <typename Visit>
EDVO_INLINE void dispatch_lens(const Distortion& lens, const Visit& visit) {
  if (lens.is_zero()) {
    visit([](const Distortion&, float x, float y) { return DistortedPoint<float>{x, y, 1, 0, 1}; });
  } else if (lens.model == DistortionModel::kannala_brandt) {
    visit([](const Distortion& fisheye, float x, float y) {
      return distort_kannala_brandt(fisheye, x, y);
    });
  } else {
    visit([](const Distortion& brown_conrady, float x, float y) {
      return distort_brown_conrady(brown_conrady, x, y);
    });
  }
}

}  // namespace vo
