#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "vo/core/instruction_set.h"
#include "vo/residuals/point_block.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// The image at some points of a view, one element per point.
struct PointSamples {
  std::span<const float> intensity;  ///< NaN where a point is not seen
  std::span<const float> u;          ///< px, where the point is looked up
  std::span<const float> v;          ///< px, where the point is looked up
};

/// Samples the image of a view at its points, 64 neighbouring points at a time.
class PointSampler {
 public:
  /// Neighbouring points, and where they are worked on.
  struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
    detail::Block* block = nullptr;
  };

  /// The view must outlive the sampler, which goes through every `stride`-th block of points.
  /// Points whose depth differs from the image's by more than the ratio `max_depth_ratio` are not
  /// seen; 0 is no such test.
  PointSampler(const PointView& view, InstructionSet set, float max_depth_ratio = 0,
               std::size_t stride = 1);
  PointSampler(const PointSampler&) = delete;
  PointSampler& operator=(const PointSampler&) = delete;

  static constexpr std::size_t kPointsPerBlock = detail::kBlock;

  std::size_t blocks() const {
    return (view_.points.size() + kPointsPerBlock - 1) / kPointsPerBlock;
  }
  static std::size_t first_of(std::size_t block) { return block * kPointsPerBlock; }

  /// Returns the image at the points of a block, valid until the next call: first of block 0, then
  /// `stride` blocks farther each time.
  PointSamples sample(std::size_t block);

 private:
  using Sample = void (*)(const PointView& view, const detail::PassWarp& warp,
                          float max_depth_ratio, const Range& next, const Range& now);

  Range range_of(std::size_t block);

  const PointView& view_;
  detail::PassWarp warp_;
  float max_depth_ratio_;
  std::size_t stride_;
  Sample sample_;
  std::array<detail::Block, 2> blocks_{};
};

}  // namespace vo
