#include "vo/mapping/epipolar_search.h"

#include <algorithm>
#include <cstddef>

#include "vo/geometry/projection.h"
#include "vo/mapping/epipolar_block.h"
#include "vo/mapping/epipolar_match.h"
#include "vo/mapping/inverse_depth_variance.h"

namespace vo {
namespace {

using detail::code;
using detail::kLines;
using detail::LineBlock;
using detail::LineSamples;
using detail::LineVariance;
using detail::SearchView;

using Targets = std::span<const SearchTarget>;
using Indices = std::vector<std::size_t>;

/// Finds the targets that are observable by the cheapest step of the search.
EDVO_INLINE void find_observable(const SearchView& view, Targets targets, Indices& observable) {
  LineBlock block;
  for (std::size_t first = 0; first < targets.size(); first += kLines) {
    const std::size_t count = std::min(kLines, targets.size() - first);
    load_targets([&](std::size_t i) { return targets[first + std::min(i, count - 1)]; }, block);
    place_cameras(view, block);
    aim_lines(view, block);
    for (std::size_t i = 0; i < count; ++i) {
      if (block.outcome[i] == code(SearchOutcome::found)) {
        observable.push_back(first + i);
      }
    }
  }
}

EDVO_INLINE void search_block(const SearchView& view, Targets targets,
                              std::span<const std::size_t> indices, LineSamples& samples,
                              std::vector<Observation>& observations) {
  LineBlock block;
  load_targets([&](std::size_t i) { return targets[indices[std::min(i, indices.size() - 1)]]; },
               block);
  place_cameras(view, block);
  aim_lines(view, block);
  project_lines(view, block);
  sample_host(view, block);
  bound_lines(block);
  match_lines(view, samples, block);
  refine_lines(view, block);
  LineVariance line_variance;
  judge_lines(view, block, line_variance);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    Observation& observation = observations[indices[i]];
    observation.outcome = static_cast<SearchOutcome>(block.outcome[i]);
    if (block.outcome[i] == code(SearchOutcome::found)) {
      observation.inverse_depth = line_variance.inverse_depth[i];
      observation.variance = line_variance.variance[i];
      observation.offset_slope = line_variance.offset_slope[i];
    }
  }
}

EDVO_INLINE void search_lines(const SearchView& view, Targets targets,
                              std::vector<Observation>& observations) {
  Indices observable;
  observable.reserve(targets.size());
  find_observable(view, targets, observable);
  LineSamples samples;
  for (std::size_t first = 0; first < observable.size(); first += kLines) {
    const std::size_t count = std::min(kLines, observable.size() - first);
    search_block(view, targets, {observable.data() + first, count}, samples, observations);
  }
}

void search_baseline(const SearchView& view, Targets targets,
                     std::vector<Observation>& observations) {
  search_lines(view, targets, observations);
}

EDVO_TARGET_AVX2 void search_avx2(const SearchView& view, Targets targets,
                                  std::vector<Observation>& observations) {
  search_lines(view, targets, observations);
}

EDVO_TARGET_AVX512 void search_avx512(const SearchView& view, Targets targets,
                                      std::vector<Observation>& observations) {
  search_lines(view, targets, observations);
}

}  // namespace

float epipolar_cos2(const StereoPair& pair, cv::Point pixel, const cv::Vec2f& gradient) {
  const cv::Vec2f& at = pair.host.rays(pixel);
  const Eigen::Vector2f ray(at[0], at[1]);
  const Eigen::Vector3f& c = pair.p_host_cur;
  const Eigen::Vector2f towards(c.x() - c.z() * ray.x(), c.y() - c.z() * ray.y());
  const ImagedDirection<float> imaged =
      image_direction(Projection<float>(pair.host.camera), ray.x(), ray.y());
  Eigen::Matrix2f J;
  J << imaged.du_dx, imaged.du_dy, imaged.dv_dx, imaged.dv_dy;
  const Eigen::Vector2f line = J * towards;
  const float along = gradient[0] * line.x() + gradient[1] * line.y();
  const float norm2 = line.squaredNorm() * (gradient[0] * gradient[0] + gradient[1] * gradient[1]);
  return norm2 > 0 ? along * along / norm2 : 0;
}

std::vector<Observation> search_epipolar_lines(const StereoPair& pair,
                                               const EpipolarOptions& options,
                                               std::span<const SearchTarget> targets,
                                               InstructionSet set) {
  std::vector<Observation> observations(targets.size());
  const SearchView view(pair, options);
  version_for(set, search_baseline, search_avx2, search_avx512)(view, targets, observations);
  return observations;
}

}  // namespace vo
