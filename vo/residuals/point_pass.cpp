#include "vo/residuals/point_pass.h"

#include <algorithm>

#include "vo/residuals/lane_sums.h"
#include "vo/residuals/point_block.h"

namespace vo {
namespace {

using detail::Block;
using detail::for_each_linearized;
using detail::kBlock;
using detail::kFlushPeriod;
using detail::LaneSums;
using detail::store_row;

EDVO_INLINE void sum_blocks(const PointView& view, const PassOptions& options,
                            PointEquations& sums) {
  LaneSums lanes;
  const std::size_t parameters = options.brightness ? kPassParameters : kPoseParameters;
  const auto add = [&](std::size_t first, std::size_t count, const Block& block)
                       EDVO_INLINE_LAMBDA {
                         for (std::size_t i = 0; i < count; ++i) {
                           sums.points += block.seen[i] > 0 ? 1 : 0;
                         }
                         lanes.add(parameters, block);
                         if ((first / kBlock) % kFlushPeriod == kFlushPeriod - 1) {
                           lanes.flush_into(sums);
                         }
                       };
  for_each_linearized(view, options, add);
  lanes.flush_into(sums);
}

EDVO_INLINE void score_blocks(const PointView& view, const PassOptions& options,
                              PointTerms& scores) {
  const auto store = [&](std::size_t first, std::size_t count, const Block& block)
                         EDVO_INLINE_LAMBDA {
                           for (std::size_t p = 0; p < kPassParameters; ++p) {
                             store_row(block.J[p], first, count, scores.J[p]);
                           }
                           store_row(block.u, first, count, scores.u);
                           store_row(block.v, first, count, scores.v);
                           store_row(block.weight, first, count, scores.weight);
                           store_row(block.residual, first, count, scores.residual);
                         };
  for_each_linearized(view, options, store);
}

void sum_baseline(const PointView& view, const PassOptions& options, PointEquations& sums) {
  sum_blocks(view, options, sums);
}

EDVO_TARGET_AVX2 void sum_avx2(const PointView& view, const PassOptions& options,
                               PointEquations& sums) {
  sum_blocks(view, options, sums);
}

EDVO_TARGET_AVX512 void sum_avx512(const PointView& view, const PassOptions& options,
                                   PointEquations& sums) {
  sum_blocks(view, options, sums);
}

void score_baseline(const PointView& view, const PassOptions& options, PointTerms& scores) {
  score_blocks(view, options, scores);
}

EDVO_TARGET_AVX2 void score_avx2(const PointView& view, const PassOptions& options,
                                 PointTerms& scores) {
  score_blocks(view, options, scores);
}

EDVO_TARGET_AVX512 void score_avx512(const PointView& view, const PassOptions& options,
                                     PointTerms& scores) {
  score_blocks(view, options, scores);
}

}  // namespace

void PointTerms::resize(std::size_t points) {
  for (std::vector<float>* values : {&weight, &residual, &u, &v}) {
    values->resize(points);
  }
  for (std::vector<float>& column : J) {
    column.resize(points);
  }
}

void PointEquations::complete(std::size_t all_points, const PassOptions& options) {
  total = all_points;
  const RobustValue at_scale = robust_value(options.loss, options.loss_scale, options.loss_scale);
  cost += static_cast<double>(total - points) * at_scale.loss;
}

PointEquations sum_points(const PointView& view, const PassOptions& options, InstructionSet set) {
  PointEquations sums;
  version_for(set, sum_baseline, sum_avx2, sum_avx512)(view, options, sums);
  sums.complete(view.points.size(), options);
  return sums;
}

void compute_point_terms(const PointView& view, const PassOptions& options, InstructionSet set,
                         PointTerms& scores) {
  scores.resize(view.points.size());
  const auto score = version_for(set, score_baseline, score_avx2, score_avx512);
  score(view, options, scores);
}

}  // namespace vo
