#include "vo/mapping/mono_initialiser.h"

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

}  // namespace

MonoInitialiser::MonoInitialiser(const FramePyramid& first, double min_parallax_px,
                                 double median_depth)
    : min_parallax_px_(min_parallax_px), median_depth_(median_depth), tracks_(first, kCorners) {
  frames_.push_back({first, SE3()});
}

bool MonoInitialiser::is_exhausted() const {
  return frames_.size() >= kMaxFrames || tracks_.alive() < std::max(kMinPairs, tracks_.size() / 3);
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
  return judge();
}

InitialiserReport MonoInitialiser::judge() {
  constexpr double kTurned = 2;         // times the parallax asked for: the image moved a lot
  constexpr double kNoParallax = 0.15;  // times the same: no more than corners err
  constexpr double kMaxResidual = 1;    // px
  constexpr double kMinInFront = 0.9;
  constexpr double kMinSignal = 15;  // parallax over what is left of it
  const std::vector<RayPair>& pairs = pairs_.back();
  const double focal_px = frames_.front().pyramid.levels.front().camera.fx;
  InitialiserReport report;
  if (pairs.size() < kMinPairs) {
    return report;
  }
  std::vector<double> flow;
  for (const RayPair& pair : pairs) {
    flow.push_back(focal_px * (pair.second - pair.first).norm());
  }
  report.flow_px = upper_median(flow);
  const RotationFit turn = fit_rotation(pairs);
  report.parallax_px = focal_px * turn.parallax;
  if (report.parallax_px < min_parallax_px_) {
    if (report.flow_px > kTurned * min_parallax_px_ &&
        report.parallax_px < kNoParallax * min_parallax_px_) {
      report.verdict = InitialiserVerdict::pure_rotation;
    }
    return report;
  }
  const TwoViewFit fit = fit_two_views(pairs, turn.T_second_first, kRobustPx / focal_px);
  if (focal_px * fit.residual > kMaxResidual || fit.in_front < kMinInFront) {
    report.verdict = InitialiserVerdict::inconsistent;
    return report;
  }
  if (report.parallax_px < kMinSignal * focal_px * fit.residual) {
    return report;
  }
  const double scale = median_depth_ * upper_median(fit.inverse_depth);
  for (std::size_t k = 0; k < fit.inverse_depth.size(); ++k) {
    known_pixels_.push_back(tracks_.start(corners_.back()[k]));
    known_inverse_depth_.push_back(fit.inverse_depth[k] / scale);
  }
  frames_.back().T_frame_first = scaled(fit.T_second_first, scale);
  place_frames();
  report.verdict = InitialiserVerdict::solved;
  return report;
}

/// The frames between the first and the last, by the corners that have a depth.
void MonoInitialiser::place_frames() {
  const double focal_px = frames_.front().pyramid.levels.front().camera.fx;
  std::vector<int> depth_of_corner(tracks_.size(), -1);
  for (std::size_t k = 0; k < corners_.back().size(); ++k) {
    depth_of_corner[corners_.back()[k]] = static_cast<int>(k);
  }
  SE3 T_guess;
  for (std::size_t f = 0; f + 1 < pairs_.size(); ++f) {
    std::vector<RayPair> pairs;
    std::vector<double> inverse_depth;
    for (std::size_t k = 0; k < pairs_[f].size(); ++k) {
      const int known = depth_of_corner[corners_[f][k]];
      if (known >= 0) {
        pairs.push_back(pairs_[f][k]);
        inverse_depth.push_back(known_inverse_depth_[static_cast<std::size_t>(known)]);
      }
    }
    T_guess = fit_pose(pairs, inverse_depth, T_guess, kRobustPx / focal_px);
    frames_[f + 1].T_frame_first = T_guess;
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
