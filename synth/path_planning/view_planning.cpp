#include "synth/path_planning/view_planning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "synth/path_planning/view_content.h"

namespace synth {
namespace {

using Eigen::Vector3d;

constexpr int kYaws = 24;
constexpr int kRenderedYaws = 12;  // the yaws between them are interpolated
constexpr std::array kPitchesDeg = {-25.0, -10.0, 5.0};
constexpr int kGazes = kYaws * static_cast<int>(kPitchesDeg.size());
constexpr double kYawStep = 2 * std::numbers::pi / kYaws;
constexpr double kAlongTheWay = 0.1;  // value of looking ahead, in shares of texture
constexpr double kTurning = 0.03;     // cost of a turn by the limit, in shares of texture

PlannedView gaze_of(int index) {
  return {kYawStep * (index % kYaws),
          kPitchesDeg.at(static_cast<std::size_t>(index / kYaws)) * std::numbers::pi / 180};
}

/// Returns the angle wrapped to -pi..pi, rad.
double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

double turn_between(const PlannedView& a, const PlannedView& b) {
  return std::hypot(wrapped(b.yaw - a.yaw), b.pitch - a.pitch);
}

using Scores = std::array<double, kGazes>;

double texture_in(const SurfaceTracer& tracer, const Vector3d& place, const PlannedView& view,
                  double reach) {
  const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(32, 24, 60);
  return view_content(tracer, camera,
                      vo::look_at(place, place + view.direction(), Vector3d::UnitY()), reach)
      .textured_share;
}

Scores score_gazes(const SurfaceTracer& tracer, const Vector3d& place, const Vector3d& ahead,
                   double reach) {
  constexpr int kStride = kYaws / kRenderedYaws;
  Scores scores{};
  for (int i = 0; i < kGazes; i += kStride) {
    scores.at(static_cast<std::size_t>(i)) = texture_in(tracer, place, gaze_of(i), reach);
  }
  for (int i = 1; i < kGazes; i += kStride) {
    const int next = i / kYaws * kYaws + (i + 1) % kYaws;
    scores.at(static_cast<std::size_t>(i)) =
        (scores.at(static_cast<std::size_t>(i - 1)) + scores.at(static_cast<std::size_t>(next))) /
        2;
  }
  for (int i = 0; i < kGazes; ++i) {
    scores.at(static_cast<std::size_t>(i)) += kAlongTheWay * gaze_of(i).direction().dot(ahead);
  }
  return scores;
}

Vector3d heading(const std::vector<Vector3d>& places, std::size_t i) {
  const Vector3d way = places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0];
  return way.norm() > 0 ? Vector3d(way.normalized()) : Vector3d::Zero();
}

/// A stage of dynamic programming: the best sum up to each view at one place, and the view before
/// it.
struct Stage {
  Scores sums{};
  std::array<int, kGazes> from{};
};

Stage next_stage(const Stage& last, const Scores& scores, double max_turn) {
  Stage stage;
  for (int to = 0; to < kGazes; ++to) {
    double best = -std::numeric_limits<double>::infinity();
    for (int from = 0; from < kGazes; ++from) {
      const double turn = turn_between(gaze_of(from), gaze_of(to));
      const double share = turn / max_turn;
      const double sum = last.sums.at(static_cast<std::size_t>(from)) - kTurning * share * share;
      if (turn <= max_turn && sum > best) {
        best = sum;
        stage.from.at(static_cast<std::size_t>(to)) = from;
      }
    }
    stage.sums.at(static_cast<std::size_t>(to)) = best + scores.at(static_cast<std::size_t>(to));
  }
  return stage;
}

std::vector<PlannedView> trace_back(const std::vector<Stage>& stages) {
  const Scores& sums = stages.back().sums;
  auto index = static_cast<int>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  std::vector<PlannedView> views(stages.size());
  for (std::size_t i = stages.size(); i-- > 0;) {
    views[i] = gaze_of(index);
    index = stages[i].from.at(static_cast<std::size_t>(index));
  }
  for (std::size_t i = 1; i < views.size(); ++i) {
    views[i].yaw = views[i - 1].yaw + wrapped(views[i].yaw - views[i - 1].yaw);
  }
  return views;
}

}  // namespace

Vector3d PlannedView::direction() const {
  return {std::cos(pitch) * std::cos(yaw), std::sin(pitch), std::cos(pitch) * std::sin(yaw)};
}

std::vector<PlannedView> plan_views(const SurfaceTracer& tracer,
                                    const std::vector<Vector3d>& places, const GazeLimits& limits) {
  std::vector<Stage> stages;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Scores scores = score_gazes(tracer, places[i], heading(places, i), limits.reach);
    stages.push_back(i == 0 ? Stage{scores, {}}
                            : next_stage(stages.back(), scores, limits.max_turn));
  }
  return trace_back(stages);
}

/// A step of yaw and a step of pitch are equally large, 15 degrees.
double least_turn() {
  constexpr double kRounding = 1e-9;
  return kYawStep + kRounding;
}

}  // namespace synth
