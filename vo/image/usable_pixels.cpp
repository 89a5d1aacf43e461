#include "vo/image/usable_pixels.h"

#include <array>
#include <limits>

#include "vo/image/depth_span.h"
#include "vo/image/pixel_bits.h"

namespace vo {
namespace {

constexpr float kNoDepth =
    std::numeric_limits<float>::infinity();  // m, to a search for the nearest

EDVO_INLINE float lesser(float a, float b) {
  return a < b ? a : b;
}

EDVO_INLINE float greater(float a, float b) {
  return a > b ? a : b;
}

EDVO_INLINE float or_far(float depth) {
  return depth > 0 ? depth : kNoDepth;
}

/// The nearest and farthest measured depths of the 3x3 pixels around each pixel of a row.
class RowSpans {
 public:
  explicit RowSpans(const DepthImage& depth)
      : depth_(depth),
        unmeasured_(static_cast<std::size_t>(depth.cols)),
        nearest_column_(unmeasured_.size() + 2, kNoDepth),
        farthest_column_(unmeasured_.size() + 2),
        nearest_(unmeasured_.size()),
        farthest_(unmeasured_.size()) {}

  EDVO_INLINE void compute(int v) {
    const float* above = v > 0 ? depth_[v - 1] : unmeasured_.data();
    const float* here = depth_[v];
    const float* below = v + 1 < depth_.rows ? depth_[v + 1] : unmeasured_.data();
    const std::size_t cols = nearest_.size();
    float* __restrict nearest_column = nearest_column_.data();
    float* __restrict farthest_column = farthest_column_.data();
    for (std::size_t u = 0; u < cols; ++u) {
      const float a = above[u] > 0 ? above[u] : 0;
      const float b = here[u] > 0 ? here[u] : 0;
      const float c = below[u] > 0 ? below[u] : 0;
      nearest_column[u + 1] = lesser(or_far(a), lesser(or_far(b), or_far(c)));
      farthest_column[u + 1] = greater(a, greater(b, c));
    }
    float* __restrict nearest = nearest_.data();
    float* __restrict farthest = farthest_.data();
    for (std::size_t u = 0; u < cols; ++u) {
      nearest[u] = lesser(nearest_column[u], lesser(nearest_column[u + 1], nearest_column[u + 2]));
      farthest[u] =
          greater(farthest_column[u], greater(farthest_column[u + 1], farthest_column[u + 2]));
    }
  }

  const float* nearest() const { return nearest_.data(); }    ///< m, infinity where there is none
  const float* farthest() const { return farthest_.data(); }  ///< m, 0 where there is none

 private:
  const DepthImage& depth_;
  std::vector<float> unmeasured_;                        ///< a row beyond the image
  std::vector<float> nearest_column_, farthest_column_;  ///< of three rows, a pixel more beside
  std::vector<float> nearest_, farthest_;
};

EDVO_INLINE void keep_usable(const float* depth, const RowSpans& spans, UsableDepth usable,
                             int cols, uchar* __restrict row) {
  const float* nearest = spans.nearest();
  const float* farthest = spans.farthest();
  for (int u = 0; u < cols; ++u) {
    const int is_smooth = farthest[u] <= nearest[u] * usable.step_ratio ? 1 : 0;
    const int is_near = depth[u] <= usable.farthest ? 1 : 0;
    const int is_far = depth[u] >= usable.nearest ? 1 : 0;
    row[u] = static_cast<uchar>(row[u] & -(is_smooth & is_near & is_far));
  }
}

EDVO_INLINE void beside_no_step(const DepthImage& depth, const UsableDepth& usable,
                                EdgeMask& mask) {
  RowSpans spans(depth);
  for (int v = 0; v < mask.rows; ++v) {
    spans.compute(v);
    keep_usable(depth[v], spans, usable, mask.cols, mask[v]);
  }
}

void beside_no_step_baseline(const DepthImage& depth, const UsableDepth& usable, EdgeMask& mask) {
  beside_no_step(depth, usable, mask);
}

EDVO_TARGET_AVX2 void beside_no_step_avx2(const DepthImage& depth, const UsableDepth& usable,
                                          EdgeMask& mask) {
  beside_no_step(depth, usable, mask);
}

bool is_near_step(const DepthImage& depth, cv::Point pixel, const UsableDepth& usable) {
  const DepthSpan span = depth_span(depth, pixel, usable.step_radius);
  return span.farthest > span.nearest * usable.step_ratio;
}

template <typename IsUsable>
std::vector<cv::Point> set_pixels(const EdgeMask& mask, IsUsable is_usable) {
  std::vector<cv::Point> pixels(static_cast<std::size_t>(cv::countNonZero(mask)));
  std::size_t count = 0;
  for (int v = 0; v < mask.rows; ++v) {
    for_each_set(mask[v], mask.cols, [&](int u) {
      pixels[count] = {u, v};
      count += is_usable(cv::Point(u, v)) ? 1 : 0;
    });
  }
  pixels.resize(count);
  return pixels;
}

}  // namespace

std::vector<cv::Point> usable_pixels(const DepthImage& depth, const EdgeMask& mask,
                                     const UsableDepth& usable, InstructionSet set) {
  if (usable.step_radius == 1) {
    EdgeMask found = mask.clone();
    if (set == InstructionSet::baseline) {
      beside_no_step_baseline(depth, usable, found);
    } else {
      beside_no_step_avx2(depth, usable, found);
    }
    return set_pixels(found, [](cv::Point) { return true; });
  }
  return set_pixels(mask, [&](cv::Point pixel) {
    return usable.is_in_range(depth(pixel)) &&
           (usable.step_radius == 0 || !is_near_step(depth, pixel, usable));
  });
}

}  // namespace vo
