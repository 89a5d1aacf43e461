#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "vo/core/image.h"

namespace vo {

/// The nearest and the farthest measured depth around a pixel, m.
struct DepthSpan {
  float nearest;
  float farthest;
};

/// Returns the span of depths up to `radius` px away in u and v. The pixel itself must have depth.
DepthSpan depth_span(const DepthImage& depth, cv::Point pixel, int radius);

/// Returns the span of the depths at most 1 px away, for a pixel with one column to its left, two
/// to its right, and a row above and below. The pixel itself must have depth.
inline DepthSpan span_of_neighbours(const float* centre, std::ptrdiff_t stride) {
#if defined(__SSE2__)
  const __m128 none = _mm_setzero_ps();
  const __m128 far = _mm_set1_ps(std::numeric_limits<float>::infinity());
  __m128 nearest = far;
  __m128 farthest = none;
  for (const float* row : {centre - stride - 1, centre - 1, centre + stride - 1}) {
    const __m128 depth = _mm_loadu_ps(row);
    const __m128 is_measured = _mm_cmpgt_ps(depth, none);
    const __m128 measured =
        _mm_or_ps(_mm_and_ps(is_measured, depth), _mm_andnot_ps(is_measured, far));
    nearest = _mm_min_ps(measured, nearest);
    farthest = _mm_max_ps(depth, farthest);
  }
#else
  using Quad = float __attribute__((vector_size(16)));
  const Quad none = {};
  const Quad far = none + std::numeric_limits<float>::infinity();
  Quad nearest = far;
  Quad farthest = none;
  for (const float* row : {centre - stride - 1, centre - 1, centre + stride - 1}) {
    Quad depth;
    std::memcpy(&depth, row, sizeof(depth));
    const Quad measured = depth > none ? depth : far;
    nearest = measured < nearest ? measured : nearest;
    farthest = depth > farthest ? depth : farthest;
  }
#endif
  return {std::min({nearest[0], nearest[1], nearest[2]}),
          std::max({farthest[0], farthest[1], farthest[2]})};
}

}  // namespace vo
