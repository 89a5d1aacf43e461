#include "vo/scale/scale_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "vo/core/median.h"
#include "vo/mapping/moved_edges.h"
#include "vo/mapping/nearest_edge.h"
#include "vo/mapping/propagate.h"

namespace vo {
namespace {

constexpr std::size_t kMostPast = 40;  ///< maps that are kept
constexpr std::size_t kMinEdges = 30;  ///< least number of shared edges

/// Errors along an edge and across a surface are alike: so many edges are worth one. With it the
/// scale of eight runs of 4 to 33 s from a first depth ended within three of its standard
/// deviations (docs/mono.md).
constexpr double kAlike = 32;

/// Standard deviation of a step about which the maps say nothing: a factor of 1.6.
constexpr double kUnknownStep = 0.5;

/// Standard deviation of the relative scale of two maps up to which they are joined.
constexpr double kMostJointSigma = 0.05;

constexpr double kSignificant = 3;  ///< standard deviations of a drift that is corrected
constexpr double kLeastCorrection = 0.02;

double squared(double value) {
  return value * value;
}

/// Returns the relation of an earlier host to a later one.
FrameRelation relation_of(const PastMap& earlier, const PastMap& later) {
  FrameRelation relation{later.T_world_host.inverse() * earlier.T_world_host};
  relation.host_motion = earlier.motion;
  relation.current_motion = later.motion;
  return relation;
}

/// Returns whether some of the earlier host's edges are in the later one's view.
bool is_seen_again(const PastMap& earlier, const PastMap& later) {
  constexpr std::size_t kStride = 64;  // every 64th edge is enough
  constexpr double kMinSeen = 0.1;
  const StereoPair pair(earlier.host.levels.front(), later.host.levels.front(),
                        relation_of(earlier, later));
  const SeenEdges edges = seen_edges(pair, earlier.hypotheses, kStride);
  return edges.seen > kMinSeen * edges.asked;
}

/// Returns the logarithms of the depth ratios, later over earlier, of the edges that both know.
std::vector<double> log_ratios(const PastMap& earlier, const PastMap& later) {
  const StereoPair pair(earlier.host.levels.front(), later.host.levels.front(),
                        relation_of(earlier, later));
  std::vector<double> ratios;
  for (const MovedEdge& moved :
       move_edges(pair, earlier.hypotheses, 0, available_instruction_set())) {
    if (!moved.is_visible || moved.is_changed ||
        !earlier.hypotheses.is_confident(moved.hypothesis, kConfidentSigma)) {
      continue;
    }
    const int found = nearest_edge(later.hypotheses, moved);
    const auto j = static_cast<std::size_t>(found);
    if (found >= 0 && later.hypotheses.is_confident(j, kConfidentSigma)) {
      ratios.push_back(std::log(moved.inverse_depth / later.hypotheses.smoothed[j]));
    }
  }
  return ratios;
}

}  // namespace

std::optional<RelativeScale> relative_scale(const PastMap& earlier, const PastMap& later) {
  constexpr double kMedianToMean = 1.2533;  // deviation of a median over that of a mean
  if (!is_seen_again(earlier, later)) {
    return std::nullopt;
  }
  const std::vector<double> ratios = log_ratios(earlier, later);
  if (ratios.size() < kMinEdges) {
    return std::nullopt;
  }
  const double median = upper_median(ratios);
  std::vector<double> magnitudes;
  for (const double ratio : ratios) {
    magnitudes.push_back(std::abs(ratio - median));
  }
  const double independent = static_cast<double>(ratios.size()) / kAlike;
  const double spread = robust_sigma(std::move(magnitudes));
  return RelativeScale{median, kMedianToMean * spread / std::sqrt(independent), ratios.size()};
}

const ScaleEstimate& ScaleWatch::add(PastMap map) {
  scale_.correction = 0;
  if (!past_.empty()) {
    carry(map);
    look_back(map);
  }
  past_.push_back({std::move(map), scale_});
  if (past_.size() > kMostPast) {
    past_.pop_front();
  }
  return scale_;
}

/// Takes the step from the last map.
void ScaleWatch::carry(const PastMap& map) {
  const std::optional<RelativeScale> step = relative_scale(past_.back().map, map);
  scale_.drift += step ? step->log_scale : 0;
  scale_.sigma = std::hypot(scale_.sigma, step ? step->sigma : kUnknownStep);
}

/// Takes in the scale relative to the earliest map that overlaps, and corrects what has drifted
/// since.
void ScaleWatch::look_back(const PastMap& map) {
  for (std::size_t i = 0; i + 1 < past_.size(); ++i) {
    const Kept& past = past_[i];
    const std::optional<RelativeScale> since = relative_scale(past.map, map);
    if (!since) {
      continue;
    }
    const double prior = squared(scale_.sigma) - squared(past.scale.sigma);
    const double gain = prior > 0 ? prior / (prior + squared(since->sigma)) : 0;
    scale_.drift += gain * (past.scale.drift + since->log_scale - scale_.drift);
    scale_.sigma = std::sqrt(squared(past.scale.sigma) + (1 - gain) * std::max(prior, 0.0));
    const double drifted = scale_.drift - past.scale.drift;
    if (gain > 0.5 && std::abs(drifted) > kLeastCorrection &&
        std::abs(since->log_scale) > kSignificant * since->sigma) {
      scale_.correction = -drifted;
      scale_.drift = past.scale.drift;
    }
    return;
  }
}

std::optional<double> ScaleWatch::take_up(const PastMap& map) {
  const Kept* best = nullptr;
  RelativeScale relative{.sigma = kMostJointSigma};
  for (const Kept& past : past_) {
    const std::optional<RelativeScale> found = relative_scale(past.map, map);
    if (found && found->sigma < relative.sigma) {
      relative = *found;
      best = &past;
    }
  }
  if (best == nullptr) {
    return std::nullopt;
  }
  scale_ = {best->scale.drift, std::hypot(best->scale.sigma, relative.sigma)};
  return relative.log_scale;
}

void ScaleWatch::lose_scale() {
  past_.clear();
  scale_.sigma = std::hypot(scale_.sigma, kUnknownStep);
}

}  // namespace vo
