#include "vo/bootstrap/mono_initialiser.h"

#include <algorithm>
#include <cmath>

#include "vo/core/median.h"

namespace vo {
namespace {

constexpr int kCorners = 400;
constexpr std::size_t kMaxFrames = 60;
constexpr std::size_t kMinPairs = 30;
constexpr double kRobustPx = 0.7;

SE3 scaled(const SE3& T, double scale) {
  return {T.rotation(), scale * T.translation()};
}

double median_flow(const std::vector<RayPair>& pairs) {
  std::vector<double> flow;
  for (const RayPair& pair : pairs) {
    flow.push_back((pair.second - pair.first).norm());
  }
  return upper_median(flow);
}

/// Fits the poses of all views to the places' depths, each from the pose of the view before.
void place(StartViews& start, double robust_scale) {
  SE3 T_before;
  for (StartView& view : start.views) {
    std::vector<double> inverse_depth;
    for (const std::size_t place : view.places) {
      inverse_depth.push_back(start.inverse_depth[place]);
    }
    view.T_frame_first = fit_pose(view.pairs, inverse_depth, T_before, robust_scale);
    T_before = view.T_frame_first;
  }
}

/// Returns at most `count` views, evenly spread, the last one included.
StartViews spread(const StartViews& start, std::size_t count) {
  const std::size_t stride = (start.views.size() + count - 1) / count;
  StartViews few{{}, start.inverse_depth};
  for (std::size_t back = 0; back < start.views.size(); back += stride) {
    few.views.insert(few.views.begin(), start.views[start.views.size() - 1 - back]);
  }
  return few;
}

/// Returns poses and depths that fit all frames, from depths that fit the last frame.
StartViews adjusted(StartViews start, double robust_scale) {
  constexpr std::size_t kMaxViews = 12;
  place(start, robust_scale);
  StartViews few = spread(start, kMaxViews);
  adjust(few, robust_scale);
  start.inverse_depth = std::move(few.inverse_depth);
  place(start, robust_scale);
  return start;
}

}  // namespace

MonoInitialiser::MonoInitialiser(const FramePyramid& first, const StartParallax& parallax,
                                 double median_depth)
    : parallax_(parallax), median_depth_(median_depth), tracks_(first, kCorners) {
  frames_.push_back({first, SE3()});
}

bool MonoInitialiser::is_exhausted() const {
  return frames_.size() >= kMaxFrames || tracks_.alive() < std::max(kMinPairs, tracks_.size() / 3);
}

/// Returns whether waiting for more parallax would cost too many corners or too much time.
bool MonoInitialiser::is_running_out() const {
  constexpr double kMinAlive = 0.4;
  const double patience =
      static_cast<double>(frames_to_least_) * parallax_.wanted_px / parallax_.least_px;
  return static_cast<double>(frames_.size()) >= std::min(patience, kMaxFrames - 1.0) ||
         static_cast<double>(tracks_.alive()) < kMinAlive * static_cast<double>(tracks_.size());
}

std::vector<RayPair> MonoInitialiser::ray_pairs() const {
  const PinholeCamera& camera = frames_.front().pyramid.levels.front().camera;
  std::vector<RayPair> pairs;
  for (const std::size_t i : corners_.back()) {
    pairs.push_back({camera.unproject(tracks_.start(i), 1).head<2>(),
                     camera.unproject(tracks_.now(i), 1).head<2>()});
  }
  return pairs;
}

InitialiserReport MonoInitialiser::add(const FramePyramid& frame) {
  tracks_.follow(frame);
  frames_.push_back({frame, SE3()});
  std::vector<std::size_t>& alive = corners_.emplace_back();
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (tracks_.is_alive(i)) {
      alive.push_back(i);
    }
  }
  pairs_.push_back(ray_pairs());
  return judge(parallax_.wanted_px);
}

InitialiserReport MonoInitialiser::finish() {
  return pairs_.empty() ? InitialiserReport() : judge(parallax_.least_px);
}

/// Solves once the parallax is sufficient, or is the least and there is no time for more.
InitialiserReport MonoInitialiser::judge(double sufficient_px) {
  constexpr double kTurned = 2;         // times the least parallax: the image moved a lot
  constexpr double kNoParallax = 0.15;  // times the least parallax: no more than corners err
  const std::vector<RayPair>& pairs = pairs_.back();
  const double focal_px = frames_.front().pyramid.levels.front().camera.fx;
  InitialiserReport report;
  if (pairs.size() < kMinPairs) {
    return report;
  }
  report.flow_px = focal_px * median_flow(pairs);
  const RotationFit turn = fit_rotation(pairs);
  report.parallax_px = focal_px * turn.parallax;
  if (report.parallax_px < parallax_.least_px) {
    if (report.flow_px > kTurned * parallax_.least_px &&
        report.parallax_px < kNoParallax * parallax_.least_px) {
      report.verdict = InitialiserVerdict::pure_rotation;
    }
    return report;
  }
  if (frames_to_least_ == 0) {
    frames_to_least_ = frames_.size();
  }
  if (report.parallax_px < sufficient_px && !is_running_out()) {
    return report;
  }
  report.verdict = solve(turn, report.parallax_px);
  return report;
}

InitialiserVerdict MonoInitialiser::solve(const RotationFit& turn, double parallax_px) {
  constexpr double kMaxResidual = 1;  // px
  constexpr double kMinInFront = 0.9;
  constexpr double kMinSignal = 15;  // least ratio of the parallax to the remaining residual
  const double focal_px = frames_.front().pyramid.levels.front().camera.fx;
  const TwoViewFit fit = fit_two_views(pairs_.back(), turn.T_second_first, kRobustPx / focal_px);
  if (focal_px * fit.residual > kMaxResidual || fit.in_front < kMinInFront) {
    return InitialiserVerdict::inconsistent;
  }
  if (parallax_px < kMinSignal * focal_px * fit.residual) {
    return InitialiserVerdict::waiting;
  }
  take(adjusted(views(fit.inverse_depth), kRobustPx / focal_px));
  return InitialiserVerdict::solved;
}

/// Returns the views of all frames of the places that have a depth.
StartViews MonoInitialiser::views(const std::vector<double>& inverse_depth) const {
  std::vector<int> place_of_corner(tracks_.size(), -1);
  for (std::size_t k = 0; k < corners_.back().size(); ++k) {
    place_of_corner[corners_.back()[k]] = static_cast<int>(k);
  }
  StartViews start{{}, inverse_depth};
  for (std::size_t f = 0; f < pairs_.size(); ++f) {
    StartView& view = start.views.emplace_back();
    for (std::size_t k = 0; k < pairs_[f].size(); ++k) {
      const int place = place_of_corner[corners_[f][k]];
      if (place >= 0) {
        view.pairs.push_back(pairs_[f][k]);
        view.places.push_back(static_cast<std::size_t>(place));
      }
    }
  }
  return start;
}

/// Takes the result of the adjustment, scaled to the median depth that was asked for.
void MonoInitialiser::take(const StartViews& adjusted) {
  const double scale = median_depth_ * upper_median(adjusted.inverse_depth);
  for (std::size_t k = 0; k < adjusted.inverse_depth.size(); ++k) {
    known_pixels_.push_back(tracks_.start(corners_.back()[k]));
    known_inverse_depth_.push_back(adjusted.inverse_depth[k] / scale);
  }
  for (std::size_t f = 0; f < adjusted.views.size(); ++f) {
    frames_[f + 1].T_frame_first = scaled(adjusted.views[f].T_frame_first, scale);
  }
}

DepthImage MonoInitialiser::depth_at_edges() const {
  constexpr std::size_t kNeighbours = 3;
  const EdgeMask& edges = frames_.front().pyramid.levels.front().edges;
  DepthImage depth(edges.size(), 0.0F);
  std::vector<std::pair<double, std::size_t>> nearest(known_pixels_.size());
  for (int v = 0; v < edges.rows; ++v) {
    for (int u = 0; u < edges.cols; ++u) {
      if (edges(v, u) == 0) {
        continue;
      }
      for (std::size_t k = 0; k < known_pixels_.size(); ++k) {
        nearest[k] = {(known_pixels_[k] - Eigen::Vector2d(u, v)).squaredNorm(), k};
      }
      const std::size_t count = std::min(kNeighbours, nearest.size());
      std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count),
                        nearest.end());
      double weights = 0;
      double sum = 0;
      for (std::size_t n = 0; n < count; ++n) {
        const double weight = 1 / (1 + nearest[n].first);
        weights += weight;
        sum += weight * known_inverse_depth_[nearest[n].second];
      }
      depth(v, u) = sum > 0 ? static_cast<float>(weights / sum) : 0.0F;
    }
  }
  return depth;
}

}  // namespace vo
