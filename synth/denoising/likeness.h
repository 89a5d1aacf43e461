#pragma once

#include <algorithm>

#include "vo/core/instruction_set.h"

namespace synth {

constexpr int kPatch = 2;            // px, reach of the patches by which light is compared
constexpr float kLightScale = 0.5F;  // standard deviations of a difference of light
constexpr float kRounding = 1e-8F;   // square of the relative difference that counts as none

/// Approximates exp(-x), x >= 0, and is 0 from 8 on.
EDVO_INLINE float falling(float x) {
  const float base = std::max(0.0F, 1 - x / 8);
  const float square = base * base;
  return square * square * (square * square);
}

/// A noisy value and its variance.
struct NoisyValue {
  float value;
  float variance;
};

/// Returns how much more two values differ than by their noise: the difference of squares over the
/// variance (Rousselle et al., Adaptive rendering with non-local means filtering, 2012).
EDVO_INLINE float difference_beyond_noise(const NoisyValue& here, const NoisyValue& there) {
  const float apart = there.value - here.value;
  const float expected = here.variance + std::min(here.variance, there.variance);
  const float rounding = kRounding * here.value * here.value + 1e-20F;
  return (apart * apart - expected) /
         (rounding + kLightScale * kLightScale * (here.variance + there.variance));
}

}  // namespace synth
