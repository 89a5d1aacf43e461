#include "vo/bootstrap/mono_initialiser.h"

#include <algorithm>
#include <cmath>

#include "vo/bootstrap/homography.h"
#include "vo/bootstrap/start_shutter.h"
#include "vo/core/median.h"
#include "vo/geometry/readout.h"

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
    std::vector<RayPair> pairs;
    for (std::size_t k = 0; k < view.pairs.size(); ++k) {
      inverse_depth.push_back(start.inverse_depth[view.places[k]]);
      pairs.push_back(view.unbent(k, start.readout.seconds));
    }
    view.T_frame_first = fit_pose(pairs, inverse_depth, T_before, robust_scale);
    T_before = view.T_frame_first;
  }
}

/// Returns at most `count` views, evenly spread, the last one included.
StartViews spread(const StartViews& start, std::size_t count) {
  const std::size_t stride = (start.views.size() + count - 1) / count;
  StartViews few{{}, start.inverse_depth, start.readout, start.readout_is_known};
  for (std::size_t back = 0; back < start.views.size(); back += stride) {
    few.views.insert(few.views.begin(), start.views[start.views.size() - 1 - back]);
  }
  return few;
}

/// Adjusts some of the views and all depths, and fits all views to these.
void adjust_some(const std::vector<double>& timestamps, double robust_scale, StartViews& start) {
  constexpr std::size_t kMaxViews = 12;
  bend_pairs(start_velocities(start, timestamps), start);
  StartViews few = spread(start, kMaxViews);
  adjust(few, robust_scale);
  start.inverse_depth = std::move(few.inverse_depth);
  start.readout = few.readout;
  place(start, robust_scale);
}

/// Returns poses, depths and read-out time that fit all frames, from depths that fit the last
/// frame, for the lines of the start's read-out. What a read-out time bends depends on poses and
/// depths, hence more rounds than one.
StartViews adjusted_along(ReadoutAxis axis, StartViews start, const std::vector<double>& timestamps,
                          double robust_scale) {
  constexpr int kRounds = 3;
  start.readout.axis = axis;
  bend_pairs(std::vector<Vector6d>(timestamps.size(), Vector6d::Zero()), start);
  place(start, robust_scale);
  for (int round = 0; round < kRounds; ++round) {
    adjust_some(timestamps, robust_scale, start);
  }
  return start;
}

/// Returns poses, depths and read-out that fit all frames, from depths that fit the last frame.
StartViews adjusted(const StartViews& first, const std::vector<double>& timestamps,
                    double robust_scale) {
  const auto along = [&](ReadoutAxis axis) {
    return adjusted_along(axis, first, timestamps, robust_scale);
  };
  if (first.readout_is_known) {
    return along(first.readout.axis);
  }
  StartViews start = along(ReadoutAxis::rows);
  if (StartViews columns = along(ReadoutAxis::columns);
      loss_of(columns, robust_scale) < loss_of(start, robust_scale)) {
    start = std::move(columns);
  }
  if (std::abs(start.readout.seconds) < kLeastMappedReadout) {
    start.readout = {};
    start.readout_is_known = true;
    place(start, robust_scale);
    adjust_some(timestamps, robust_scale, start);
  }
  return start;
}

/// Returns by how much more than the loss of the best start another must have, as a share of it,
/// for neither the corners' noise nor what is alike in their errors to explain the difference.
double clear_margin(const StartViews& best) {
  constexpr double kSystematic = 0.1;
  constexpr double kChance = 64;  // 4 standard deviations squared, four corners worth one
  double freedom = -static_cast<double>(best.inverse_depth.size());
  for (const StartView& view : best.views) {
    freedom += 2 * static_cast<double>(view.pairs.size()) - 6;
  }
  return std::max(kSystematic, kChance / std::max(freedom, 1.0));
}

/// Returns the start of the least loss, or null if another is about as good.
const StartViews* clearly_best(const std::vector<StartViews>& starts, double robust_scale) {
  std::vector<double> losses;
  for (const StartViews& start : starts) {
    losses.push_back(loss_of(start, robust_scale));
  }
  const auto least = std::min_element(losses.begin(), losses.end());
  const StartViews& best = starts[static_cast<std::size_t>(least - losses.begin())];
  const double alike = *least * (1 + clear_margin(best));
  const auto rivals =
      std::count_if(losses.begin(), losses.end(), [&](double loss) { return loss < alike; });
  return rivals > 1 ? nullptr : &best;
}

}  // namespace

MonoInitialiser::MonoInitialiser(const FramePyramid& first, const StartParallax& parallax,
                                 double median_depth, std::optional<Readout> known_readout)
    : parallax_(parallax),
      median_depth_(median_depth),
      readout_(known_readout.value_or(Readout())),
      readout_is_known_(known_readout.has_value()),
      tracks_(first, kCorners) {
  frames_.push_back({first, SE3()});
}

bool MonoInitialiser::is_exhausted() const {
  return frames_.size() >= kMaxFrames || tracks_.alive() < std::max(kMinPairs, tracks_.size() / 3);
}

/// Returns whether waiting for more parallax would cost too many corners or too much time.
bool MonoInitialiser::is_running_out() const {
  constexpr double kMinAlive = 0.4;
  constexpr double kPatience = 3;  // times the frames until the least parallax
  const double patience = kPatience * static_cast<double>(frames_to_least_);
  return static_cast<double>(frames_.size()) >= std::min(patience, kMaxFrames - 1.0) ||
         static_cast<double>(tracks_.alive()) < kMinAlive * static_cast<double>(tracks_.size());
}

std::vector<RayPair> MonoInitialiser::ray_pairs() const {
  const PinholeCamera& camera = frames_.front().pyramid.levels.front().camera;
  const auto from_middle = [inverse_width = 1 / static_cast<float>(camera.width),
                            inverse_height = 1 / static_cast<float>(camera.height)](
                               const Eigen::Vector2d& pixel) {
    const Eigen::Vector2f uv = pixel.cast<float>();
    return Eigen::Vector2d(past_middle(uv.x(), inverse_width), past_middle(uv.y(), inverse_height));
  };
  std::vector<RayPair> pairs;
  for (const std::size_t i : corners_.back()) {
    const Eigen::Vector2d& start = tracks_.start(i);
    const Eigen::Vector2d& now = tracks_.now(i);
    pairs.push_back({camera.unproject(start, 1).head<2>(), camera.unproject(now, 1).head<2>(),
                     from_middle(start), from_middle(now)});
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

double MonoInitialiser::robust_scale() const {
  return kRobustPx / frames_.front().pyramid.levels.front().camera.fx;
}

std::vector<double> MonoInitialiser::timestamps() const {
  std::vector<double> timestamps;
  for (const StartFrame& frame : frames_) {
    timestamps.push_back(frame.pyramid.timestamp);
  }
  return timestamps;
}

/// Returns the motions and depths that explain the last frame: one, or those of a plane.
std::vector<TwoViewFit> MonoInitialiser::explanations(const RotationFit& turn) const {
  constexpr double kMaxResidual = 1 / kRobustPx;  // robust scales, 1 px
  constexpr double kMinInFront = 0.9;
  const std::vector<RayPair>& pairs = pairs_.back();
  std::vector<TwoViewFit> fits{fit_two_views(pairs, turn.T_second_first, robust_scale())};
  const Eigen::Matrix3d H = fit_homography(pairs, turn.T_second_first);
  if (is_planar(pairs, H, fits.front(), robust_scale())) {
    fits.clear();
    for (const SE3& T : motions_of_plane(pairs, H, kMinInFront)) {
      fits.push_back(refine_two_views(pairs, T, robust_scale()));
    }
  }
  std::erase_if(fits, [&](const TwoViewFit& fit) {
    return fit.residual > kMaxResidual * robust_scale() || fit.in_front < kMinInFront;
  });
  return fits;
}

InitialiserVerdict MonoInitialiser::solve(const RotationFit& turn, double parallax_px) {
  constexpr double kMinSignal = 15;  // least ratio of the parallax to the remaining residual
  const double focal_px = frames_.front().pyramid.levels.front().camera.fx;
  const std::vector<TwoViewFit> fits = explanations(turn);
  if (fits.empty()) {
    return InitialiserVerdict::inconsistent;
  }
  if (parallax_px < kMinSignal * focal_px * fits.front().residual) {
    return InitialiserVerdict::waiting;
  }
  std::vector<StartViews> starts;
  for (const TwoViewFit& fit : fits) {
    starts.push_back(adjusted(views(fit.inverse_depth), timestamps(), robust_scale()));
  }
  const StartViews* start = clearly_best(starts, robust_scale());
  if (start == nullptr) {
    return InitialiserVerdict::ambiguous;
  }
  take(*start, start_velocities(*start, timestamps()));
  return InitialiserVerdict::solved;
}

/// Returns the views of all frames of the places that have a depth.
StartViews MonoInitialiser::views(const std::vector<double>& inverse_depth) const {
  std::vector<int> place_of_corner(tracks_.size(), -1);
  for (std::size_t k = 0; k < corners_.back().size(); ++k) {
    place_of_corner[corners_.back()[k]] = static_cast<int>(k);
  }
  StartViews start{{}, inverse_depth, readout_, readout_is_known_};
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
void MonoInitialiser::take(const StartViews& adjusted, const std::vector<Vector6d>& velocities) {
  const double scale = median_depth_ * upper_median(adjusted.inverse_depth);
  for (std::size_t k = 0; k < adjusted.inverse_depth.size(); ++k) {
    known_pixels_.push_back(tracks_.start(corners_.back()[k]));
    known_inverse_depth_.push_back(adjusted.inverse_depth[k] / scale);
  }
  for (std::size_t f = 0; f < adjusted.views.size(); ++f) {
    frames_[f + 1].T_frame_first = scaled(adjusted.views[f].T_frame_first, scale);
  }
  readout_ = adjusted.readout;
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    frames_[f].velocity << scale * velocities[f].head<3>(), velocities[f].tail<3>();
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
