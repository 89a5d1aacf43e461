#include "vo/image/usable_pixels.h"

#include <cstddef>

#include "vo/core/instruction_set.h"
#include "vo/core/pixel_bits.h"
#include "vo/image/depth_span.h"

namespace vo {
namespace {

/// Tests whether measured depths near the pixels of a row differ by more than the ratio.
class StepDetector {
 public:
  StepDetector(const DepthImage& depth, const UsableDepth& usable, int v)
      : depth_(depth),
        row_(depth[v]),
        stride_(static_cast<std::ptrdiff_t>(depth.step1())),
        usable_(usable),
        v_(v),
        last_simple_(usable.step_radius == 1 && v > 0 && v + 1 < depth.rows ? depth.cols - 3 : 0) {}

  EDVO_INLINE bool is_near_step(int u) const {
    if (usable_.step_radius == 0) {
      return false;
    }
    const DepthSpan span = u >= 1 && u <= last_simple_
                               ? span_of_neighbours(row_ + u, stride_)
                               : depth_span(depth_, {u, v_}, usable_.step_radius);
    return span.farthest > span.nearest * usable_.step_ratio;
  }

 private:
  const DepthImage& depth_;
  const float* row_;
  std::ptrdiff_t stride_;
  UsableDepth usable_;
  int v_;
  int last_simple_;  ///< px, last column with the neighbours that span_of_neighbours reads
};

/// Prefetches a row of depths, because edge pixels are too far apart for the processor to do so.
void prefetch(const DepthImage& depth, int v) {
  constexpr int kPixelsPerLine = 16;  // pixels in a cache line
  for (int u = 0; u < depth.cols && v < depth.rows; u += kPixelsPerLine) {
    __builtin_prefetch(depth[v] + u);
  }
}

}  // namespace

void find_usable_pixels(const DepthImage& depth, const EdgeMask& mask, const UsableDepth& usable,
                        std::vector<cv::Point>& pixels) {
  pixels.resize(static_cast<std::size_t>(cv::countNonZero(mask)));
  std::size_t count = 0;
  for (int v = 0; v < mask.rows; ++v) {
    constexpr int kRowsAhead = 3;
    prefetch(depth, v + kRowsAhead);
    const float* row = depth[v];
    const StepDetector steps(depth, usable, v);
    for_each_set(mask[v], mask.cols, [&](int u) {
      pixels[count] = {u, v};
      count += usable.is_in_range(row[u]) && !steps.is_near_step(u) ? 1 : 0;
    });
  }
  pixels.resize(count);
}

}  // namespace vo
