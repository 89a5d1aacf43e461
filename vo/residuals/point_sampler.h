#pragma once

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
  /// The view must outlive the sampler. Points whose depth differs from the image's by more than
  /// the ratio `max_depth_ratio` are not seen; 0 is no such test.
  PointSampler(const PointView& view, InstructionSet set, float max_depth_ratio = 0);

  static constexpr std::size_t kPointsPerBlock = detail::kBlock;

  std::size_t blocks() const {
    return (view_.points.size() + kPointsPerBlock - 1) / kPointsPerBlock;
  }
  static std::size_t first_of(std::size_t block) { return block * kPointsPerBlock; }

  /// Returns the image at the points of a block, valid until the next call.
  PointSamples sample(std::size_t block);

 private:
  using Sample = void (*)(const PointView& view, const detail::PassWarp& warp,
                          float max_depth_ratio, std::size_t first, std::size_t count,
                          detail::Block& block);

  const PointView& view_;
  detail::PassWarp warp_;
  float max_depth_ratio_;
  Sample sample_;
  detail::Block block_{};
};

}  // namespace vo
