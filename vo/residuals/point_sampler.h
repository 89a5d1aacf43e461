#pragma once

#include <cstddef>
#include <span>

#include "vo/core/instruction_set.h"
#include "vo/residuals/point_block.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// Samples the image of a view at its points, 64 neighbouring points at a time.
class PointSampler {
 public:
  /// The view must outlive the sampler.
  PointSampler(const PointView& view, InstructionSet set);

  std::size_t blocks() const { return (view_.points.size() + detail::kBlock - 1) / detail::kBlock; }
  static std::size_t first_of(std::size_t block) { return block * detail::kBlock; }

  /// Returns the intensities at the points of a block, NaN where a point is not seen. They are
  /// valid until the next call.
  std::span<const float> sample(std::size_t block);

 private:
  using Sample = void (*)(const PointView& view, const detail::PassWarp& warp, std::size_t first,
                          std::size_t count, detail::Block& block);

  const PointView& view_;
  detail::PassWarp warp_;
  Sample sample_;
  detail::Block block_{};
};

}  // namespace vo
