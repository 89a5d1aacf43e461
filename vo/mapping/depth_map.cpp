#include "vo/mapping/depth_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "vo/core/hash.h"
#include "vo/core/median.h"
#include "vo/image/depth_span.h"
#include "vo/mapping/chains.h"
#include "vo/mapping/fuse.h"
#include "vo/mapping/map_points.h"

namespace vo {
namespace {

constexpr double kMinHostOverlap = 0.7;  ///< least share of the host's edges in view
constexpr double kSearchSigmas = 2;      ///< standard deviations, half the searched interval

/// The depth of an edge pixel in a depth image, m, and its relative standard deviation.
struct EdgeDepth {
  float depth = 0;
  float relative_sigma = 0;
};

/// Returns the depth of an edge pixel. At a step the edge is mostly the near surface's, whichever
/// of the two its pixel lies on; but texture of the far one ends there, too. The depth is 0 where
/// the pixel has none.
EdgeDepth depth_of_edge(const DepthImage& depth, cv::Point pixel, float relative_sigma) {
  constexpr float kStep = 1.05F;
  if (!has_depth(depth(pixel))) {
    return {};
  }
  const DepthSpan span = depth_span(depth, pixel, 1);
  const float half_step = 0.5F * (1 - span.nearest / span.farthest);
  if (span.farthest <= kStep * span.nearest || half_step <= relative_sigma) {
    return {depth(pixel), relative_sigma};
  }
  return {span.nearest, half_step};
}

}  // namespace

DepthMap::DepthMap(const DepthMapOptions& options) : options_(options) {
  options_.validate();
}

void DepthMap::start(const FramePyramid& host, double guessed_depth) {
  host_ = host;
  past_hosts_.clear();
  frames_since_host_ = 0;
  hypotheses_ =
      edge_hypotheses(host.levels.front(), options_, static_cast<float>(1 / guessed_depth));
  cells_ = point_cells(host_, hypotheses_);
}

void DepthMap::take_depth(const DepthImage& depth, double relative_sigma) {
  assert(depth.size() == host_.levels.front().intensity.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const EdgeDepth edge =
        depth_of_edge(depth, hypotheses_.pixel[i], static_cast<float>(relative_sigma));
    if (has_depth(edge.depth)) {
      const float sigma = edge.relative_sigma / edge.depth;
      hypotheses_.set(i, 1 / edge.depth, sigma * sigma);
    }
  }
}

void DepthMap::guess_random(std::uint64_t seed) {
  const double far = 1 / options_.max_depth;
  const double near = 1 / options_.min_depth;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const double uniform = mixed_uniform(mixed(seed) + i);
    hypotheses_.forget(i, static_cast<float>(far + uniform * (near - far)));
  }
}

void DepthMap::correct(const EdgePointLevel& points) {
  std::vector<float> change(hypotheses_.size(), 0);
  std::vector<float> changes;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto i = static_cast<std::size_t>(hypotheses_.index(points.pixel[k]));
    change[i] = 1 / (points.z_ref[k] * hypotheses_.smoothed[i]);
    changes.push_back(change[i]);
  }
  if (changes.empty()) {
    return;
  }
  const float median = upper_median(changes);
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const float factor = change[i] > 0 ? change[i] : median;
    hypotheses_.inverse_depth[i] *= factor;
    hypotheses_.smoothed[i] *= factor;
  }
}

void DepthMap::take_out(const Vignette& vignette) {
  if (is_noticeable(host_.vignette, vignette)) {
    host_ = without_vignette(std::move(host_), vignette);
  }
}

void DepthMap::rescale(double factor) {
  const auto growth = static_cast<float>(1 / factor);
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    hypotheses_.inverse_depth[i] *= growth;
    hypotheses_.smoothed[i] *= growth;
    hypotheses_.offset_covariance[i] *= growth;
    hypotheses_.variance[i] *= growth * growth;
    hypotheses_.smoothed_variance[i] *= growth * growth;
  }
}

bool DepthMap::needs_new_host(const FramePyramid& current, const SE3& T_cur_host) const {
  return options_.propagate == PropagationPolicy::always ||
         (options_.host.every > 0 && frames_since_host_ >= options_.host.every) ||
         view_has_changed(current, T_cur_host);
}

bool DepthMap::view_has_changed(const FramePyramid& current, const SE3& T_cur_host) const {
  const HostOptions& options = options_.host;
  constexpr std::size_t kStride = 8;  // every eighth edge is enough
  const StereoPair pair(host_.levels.front(), current.levels.front(), {T_cur_host});
  const SeenEdges edges = seen_edges(pair, hypotheses_, kStride);
  return edges.seen < kMinHostOverlap * edges.asked ||
         edges.flow_px > edges.seen * options.max_flow * pair.current.camera.width;
}

SearchTarget DepthMap::target(std::size_t i) const {
  const float d = hypotheses_.inverse_depth[i];
  SearchTarget target{hypotheses_.pixel[i],
                      hypotheses_.ray[i],
                      hypotheses_.gradient[i],
                      d,
                      static_cast<float>(1 / options_.min_depth),
                      static_cast<float>(1 / options_.max_depth)};
  if (hypotheses_.state[i] != DepthState::none) {
    const float reach = static_cast<float>(kSearchSigmas) * std::sqrt(hypotheses_.variance[i]);
    target.nearest = d + reach;
    target.farthest = std::max(d - reach, 0.0F);
  }
  return target;
}

void DepthMap::count_and_fuse(const Observation& observation, std::size_t i, float guess,
                              ObservationCounts& counts) {
  const Innovation step = innovation(observation, i, hypotheses_);
  const auto gate = static_cast<float>(options_.gate_sigmas * options_.gate_sigmas);
  const bool consistent = hypotheses_.state[i] == DepthState::none ||
                          options_.fusion == Fusion::gaussian_beta ||
                          step.difference * step.difference <= gate * step.variance;
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
  ++frames_since_host_;
  const StereoPair pair(host_.levels.front(), current.levels.front(), relation);
  std::vector<SearchTarget> targets;
  targets.reserve(hypotheses_.size());
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    targets.push_back(target(i));
  }
  const std::vector<Observation> observations =
      search_epipolar_lines(pair, options_.epipolar, targets);
  const float guess = median_inverse_depth(hypotheses_, static_cast<float>(2 / options_.max_depth));
  ObservationCounts counts;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const Observation& observation = observations[i];
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
    hypotheses_.smoothed_variance = hypotheses_.variance;
    return;
  }
  const float guess = median_inverse_depth(hypotheses_, static_cast<float>(2 / options_.max_depth));
  forget_lonely(guess, hypotheses_);
  smooth_along_chains(hypotheses_);
}

PropagationCounts DepthMap::propagate(const FramePyramid& current, const FrameRelation& relation) {
  const float guess = median_inverse_depth(hypotheses_, static_cast<float>(2 / options_.max_depth));
  Hypotheses next = edge_hypotheses(current.levels.front(), options_, guess);
  const StereoPair pair(host_.levels.front(), current.levels.front(), relation);
  const PropagationCounts counts = vo::propagate(pair, hypotheses_, next);
  fill_from_neighbours(next);
  hypotheses_ = std::move(next);
  FramePyramid last_host = std::exchange(host_, current);
  cells_ = point_cells(host_, hypotheses_);
  if (options_.propagate == PropagationPolicy::always) {
    look_back(std::move(last_host), relation);
  }
  frames_since_host_ = 0;
  return counts;
}

void DepthMap::look_back(FramePyramid last_host, const FrameRelation& relation) {
  constexpr std::size_t kMostPast = 20;  // limit for a camera that stands still
  const SE3 T_last_host = relation.T_cur_host.inverse();
  for (PastHost& past : past_hosts_) {
    past.T_past_host = past.T_past_host * T_last_host;
  }
  past_hosts_.push_back({std::move(last_host), T_last_host});
  const auto is_left_behind = [this](const PastHost& past) {
    return past_hosts_.size() > kMostPast || view_has_changed(past.frame, past.T_past_host);
  };
  while (past_hosts_.size() > 1 && is_left_behind(past_hosts_.front())) {
    past_hosts_.pop_front();
  }
  if (past_hosts_.size() > 1) {
    const PastHost& earliest = past_hosts_.front();
    observe(earliest.frame, {earliest.T_past_host, relation.covariance});
  }
}

EdgePoints DepthMap::points(const EdgePointOptions& options, Guesses guesses) const {
  return map_points(host_, cells_, hypotheses_, options, kConfidentSigma, guesses);
}

std::size_t DepthMap::confident() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    count += hypotheses_.is_confident(i, kConfidentSigma) ? 1 : 0;
  }
  return count;
}

}  // namespace vo
