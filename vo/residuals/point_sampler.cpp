#include "vo/residuals/point_sampler.h"

#include <algorithm>
#include <limits>

namespace vo {
namespace {

using detail::Block;
using detail::kBlock;
using detail::PassWarp;

/// Some neighbouring points of a view.
using Range = PointSampler::Range;

/// Finds where the points `next` are seen, then looks up the image at those of `now`, which had
/// been found before: the memory of the next ones is on its way meanwhile.
EDVO_INLINE void sample_points(const PointView& view, const PassWarp& warp, float max_depth_ratio,
                               const Range& next, const Range& now) {
  constexpr float kUnseen = std::numeric_limits<float>::quiet_NaN();
  if (next.count > 0) {
    Block& block = *next.block;
    load_points(view.points, next.first, next.count, block);
    warp_block(warp, next.count, block);
    find_corners(view.image.intensity, 1, 2, block);
    if (max_depth_ratio > 0) {
      find_depth_pixels(view.image.depth, block);
    }
  }
  if (now.count > 0) {
    Block& block = *now.block;
    sample_block_intensity(view.image.intensity, block);
    if (max_depth_ratio > 0) {
      test_depth(view.image.depth, max_depth_ratio, now.count, block);
    }
    for (std::size_t i = 0; i < kBlock; ++i) {
      block.intensity[i] = block.seen[i] > 0 ? block.intensity[i] : kUnseen;
    }
  }
}

void sample_baseline(const PointView& view, const PassWarp& warp, float max_depth_ratio,
                     const Range& next, const Range& now) {
  sample_points(view, warp, max_depth_ratio, next, now);
}

EDVO_TARGET_AVX2 void sample_avx2(const PointView& view, const PassWarp& warp,
                                  float max_depth_ratio, const Range& next, const Range& now) {
  sample_points(view, warp, max_depth_ratio, next, now);
}

EDVO_TARGET_AVX512 void sample_avx512(const PointView& view, const PassWarp& warp,
                                      float max_depth_ratio, const Range& next, const Range& now) {
  sample_points(view, warp, max_depth_ratio, next, now);
}

}  // namespace

PointSampler::PointSampler(const PointView& view, InstructionSet set, float max_depth_ratio,
                           std::size_t stride)
    : view_(view),
      warp_(view),
      max_depth_ratio_(max_depth_ratio),
      stride_(stride),
      sample_(version_for(set, sample_baseline, sample_avx2, sample_avx512)) {
  sample_(view_, warp_, max_depth_ratio_, range_of(0), {});
}

/// Returns the points of a block, which is none where there are no more points.
PointSampler::Range PointSampler::range_of(std::size_t block) {
  const std::size_t first = std::min(first_of(block), view_.points.size());
  return {first, std::min(kBlock, view_.points.size() - first), &blocks_[block / stride_ % 2]};
}

PointSamples PointSampler::sample(std::size_t block) {
  const Range now = range_of(block);
  sample_(view_, warp_, max_depth_ratio_, range_of(block + stride_), now);
  return {{now.block->intensity.data(), now.count},
          {now.block->u.data(), now.count},
          {now.block->v.data(), now.count}};
}

}  // namespace vo
