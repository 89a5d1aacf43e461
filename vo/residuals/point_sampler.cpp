#include "vo/residuals/point_sampler.h"

#include <algorithm>
#include <limits>

namespace vo {
namespace {

using detail::Block;
using detail::kBlock;
using detail::PassWarp;

EDVO_INLINE void sample_points(const PointView& view, const PassWarp& warp, float max_depth_ratio,
                               std::size_t first, std::size_t count, Block& block) {
  constexpr float kUnseen = std::numeric_limits<float>::quiet_NaN();
  load_points(view.points, first, count, block);
  warp_block(warp, count, block);
  sample_block_intensity(view.image.intensity, block);
  if (max_depth_ratio > 0) {
    test_depth(view.image.depth, max_depth_ratio, count, block);
  }
  for (std::size_t i = 0; i < kBlock; ++i) {
    block.intensity[i] = block.seen[i] > 0 ? block.intensity[i] : kUnseen;
  }
}

void sample_baseline(const PointView& view, const PassWarp& warp, float max_depth_ratio,
                     std::size_t first, std::size_t count, Block& block) {
  sample_points(view, warp, max_depth_ratio, first, count, block);
}

EDVO_TARGET_AVX2 void sample_avx2(const PointView& view, const PassWarp& warp,
                                  float max_depth_ratio, std::size_t first, std::size_t count,
                                  Block& block) {
  sample_points(view, warp, max_depth_ratio, first, count, block);
}

EDVO_TARGET_AVX512 void sample_avx512(const PointView& view, const PassWarp& warp,
                                      float max_depth_ratio, std::size_t first, std::size_t count,
                                      Block& block) {
  sample_points(view, warp, max_depth_ratio, first, count, block);
}

}  // namespace

PointSampler::PointSampler(const PointView& view, InstructionSet set, float max_depth_ratio)
    : view_(view),
      warp_(view),
      max_depth_ratio_(max_depth_ratio),
      sample_(set == InstructionSet::avx512 ? sample_avx512
              : set == InstructionSet::avx2 ? sample_avx2
                                            : sample_baseline) {}

PointSamples PointSampler::sample(std::size_t block) {
  const std::size_t first = first_of(block);
  const std::size_t count = std::min(kBlock, view_.points.size() - first);
  sample_(view_, warp_, max_depth_ratio_, first, count, block_);
  return {{block_.intensity.data(), count}, {block_.u.data(), count}, {block_.v.data(), count}};
}

}  // namespace vo
