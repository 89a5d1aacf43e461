#include "vo/mapping/depth_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "vo/core/hash.h"
#include "vo/mapping/chains.h"
#include "vo/mapping/fuse.h"
#include "vo/mapping/map_points.h"

namespace vo {

DepthMap::DepthMap(const DepthMapOptions& options) : options_(options) {
  options_.validate();
}

void DepthMap::start(const FramePyramid& anchor, double guessed_depth) {
  anchor_ = anchor;
  hypotheses_ =
      edge_hypotheses(anchor.levels.front(), options_, static_cast<float>(1 / guessed_depth));
}

void DepthMap::take_depth(const DepthImage& depth, double relative_sigma) {
  assert(depth.size() == anchor_.levels.front().intensity.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const float z = depth(hypotheses_.pixel[i]);
    if (has_depth(z)) {
      const float sigma = static_cast<float>(relative_sigma) / z;
      hypotheses_.set(i, 1 / z, sigma * sigma);
    }
  }
}

void DepthMap::guess_flat(double depth, double relative_sigma) {
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const double sigma = relative_sigma / depth;
    hypotheses_.set(i, static_cast<float>(1 / depth), static_cast<float>(sigma * sigma));
  }
}

void DepthMap::guess_random(std::uint64_t seed, double relative_sigma) {
  const double far = 1 / options_.max_depth;
  const double near = 1 / options_.min_depth;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const double uniform = static_cast<double>(mixed(mixed(seed) + i)) * 0x1p-64;
    const double d = far + uniform * (near - far);
    const double sigma = relative_sigma * d;
    hypotheses_.set(i, static_cast<float>(d), static_cast<float>(sigma * sigma));
  }
}

SearchTarget DepthMap::target(std::size_t i) const {
  const float d = hypotheses_.inverse_depth[i];
  SearchTarget target{hypotheses_.pixel[i], hypotheses_.gradient[i], d,
                      static_cast<float>(1 / options_.min_depth),
                      static_cast<float>(1 / options_.max_depth)};
  if (hypotheses_.knowledge[i] != Knowledge::none) {
    const float reach =
        static_cast<float>(options_.epipolar.search_sigmas) * std::sqrt(hypotheses_.variance[i]);
    target.nearest = d + reach;
    target.farthest = std::max(d - reach, 0.0F);
  }
  return target;
}

void DepthMap::count_and_fuse(const Observation& observation, std::size_t i, float guess,
                              ObservationCounts& counts) {
  const float difference = observation.inverse_depth - hypotheses_.inverse_depth[i];
  const auto gate = static_cast<float>(options_.gate_sigmas * options_.gate_sigmas);
  const bool consistent =
      hypotheses_.knowledge[i] == Knowledge::none || options_.fusion == Fusion::gaussian_beta ||
      difference * difference <= gate * (hypotheses_.variance[i] + observation.variance);
  if (consistent) {
    ++counts.found;
    fuse(observation, options_, i, hypotheses_);
  } else {
    ++counts.inconsistent;
    count_failure(options_, guess, i, hypotheses_);
  }
}

ObservationCounts DepthMap::observe(const FramePyramid& current, const FrameRelation& relation,
                                    const ObservationListener& listener) {
  const StereoPair pair(anchor_.levels.front(), current.levels.front(), relation);
  EpipolarSearch search(pair, options_.epipolar);
  const float guess = median_inverse_depth(hypotheses_, static_cast<float>(2 / options_.max_depth));
  ObservationCounts counts;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const Observation observation = search.observe(target(i));
    if (listener) {
      listener(i, observation);
    }
    switch (observation.outcome) {
      case SearchOutcome::found:
        count_and_fuse(observation, i, guess, counts);
        break;
      case SearchOutcome::out_of_view:
        ++counts.out_of_view;
        break;
      case SearchOutcome::unobservable:
        ++counts.unobservable;
        break;
      case SearchOutcome::ambiguous:
        ++counts.ambiguous;
        break;
      case SearchOutcome::no_match:
        ++counts.no_match;
        count_failure(options_, guess, i, hypotheses_);
        break;
    }
  }
  return counts;
}

void DepthMap::regularise() {
  if (options_.regularise == Regularisation::none) {
    hypotheses_.smoothed = hypotheses_.inverse_depth;
    return;
  }
  const float guess = median_inverse_depth(hypotheses_, static_cast<float>(2 / options_.max_depth));
  forget_lonely(options_, guess, hypotheses_);
  smooth_along_chains(hypotheses_);
}

PropagationCounts DepthMap::propagate(const FramePyramid& current, const FrameRelation& relation) {
  const float guess = median_inverse_depth(hypotheses_, static_cast<float>(2 / options_.max_depth));
  Hypotheses next = edge_hypotheses(current.levels.front(), options_, guess);
  const StereoPair pair(anchor_.levels.front(), current.levels.front(), relation);
  const PropagationCounts counts = vo::propagate(pair, hypotheses_, options_, next);
  fill_from_neighbours(options_, next);
  hypotheses_ = std::move(next);
  anchor_ = current;
  return counts;
}

EdgePoints DepthMap::points(const EdgePointOptions& options) const {
  return map_points(anchor_, hypotheses_, options, options_.confident_sigma);
}

std::size_t DepthMap::confident() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    count += hypotheses_.knowledge[i] != Knowledge::none &&
                     hypotheses_.relative_sigma(i) <= options_.confident_sigma
                 ? 1
                 : 0;
  }
  return count;
}

}  // namespace vo
