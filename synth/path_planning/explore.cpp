#include "synth/path_planning/explore.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "synth/path/rest_spline.h"
#include "synth/path_planning/free_space.h"
#include "synth/path_planning/roadmap.h"
#include "synth/path_planning/view_planning.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Vector5d = Eigen::Matrix<double, 5, 1>;  ///< position, yaw, pitch

/// The parameters of the path, with all defaults resolved.
struct Plan {
  double scale = 0;      ///< m, typical distance to what is seen
  double clearance = 0;  ///< m, least distance to surfaces
  double spacing = 0;    ///< m between control points, at most
  double step = 0;       ///< s between control points
  std::size_t controls = 0;

  double margin() const { return clearance + 1.1 * spacing; }  ///< m, clearance before smoothing
};

Plan make_plan(const ExploreOptions& options, double scale, double duration_s) {
  Plan plan{.scale = scale};
  plan.clearance = options.clearance > 0 ? options.clearance : scale / 10;
  plan.spacing = 0.4 * plan.clearance;
  plan.step = plan.spacing / (options.speed > 0 ? options.speed : scale / 5);
  const double steps =
      options.length > 0 ? options.length / plan.spacing + 1 : duration_s / plan.step - 1;
  constexpr double kMost = 1e5;
  vo::require(steps >= 2, "explore: no time to go anywhere, expected at least ", 3 * plan.step,
              " s, a higher explore.speed or a smaller explore.clearance than ", plan.clearance,
              " m");
  vo::require(steps < kMost, "explore: expected a shorter length, or a greater clearance");
  plan.controls = static_cast<std::size_t>(steps);
  return plan;
}

/// Returns the first `count` points along the polyline, `spacing` apart.
std::vector<Vector3d> resampled(const std::vector<Vector3d>& polyline, double spacing,
                                std::size_t count) {
  std::vector<Vector3d> points = {polyline.front()};
  double ahead = spacing;  // from the start of the segment to the next point
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Vector3d segment = polyline[i] - polyline[i - 1];
    for (; ahead <= segment.norm() && points.size() < count; ahead += spacing) {
      points.emplace_back(polyline[i - 1] + segment.normalized() * ahead);
    }
    ahead -= segment.norm();
  }
  return points;
}

/// Smooths an elastic band: every point moves towards the middle of its neighbours while it keeps a
/// clearance of `margin`, m.
void relax(const FreeSpace& space, double margin, std::vector<Vector3d>& points) {
  constexpr int kRounds = 40;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Vector3d drawn = (points[i - 1] + 2 * points[i] + points[i + 1]) / 4;
      if (space.clearance(drawn, 2 * margin) >= margin) {
        points[i] = drawn;
      }
    }
  }
}

std::vector<Vector3d> find_way(const FreeSpace& space, const ExploredRegion& region,
                               const Plan& plan, std::uint64_t seed) {
  constexpr double kRounding = 1.07;  // is_free keeps its radius up to a sixteenth
  const Roadmap roadmap = make_roadmap(space, region, kRounding * plan.margin(), seed);
  vo::require(!roadmap.places.empty(), "explore: found no free space with a clearance of ",
              plan.clearance, " m; expected a smaller explore.clearance or another scene");
  constexpr double kShrinking = 1.5;  // greatest factor by which relaxing shortens
  const double length = plan.spacing * static_cast<double>(plan.controls);
  std::vector<Vector3d> points =
      resampled(wander(roadmap, kShrinking * length + 1, seed), plan.spacing,
                static_cast<std::size_t>(kShrinking * static_cast<double>(plan.controls)) + 2);
  relax(space, plan.margin(), points);
  return resampled(points, plan.spacing, plan.controls);
}

/// Returns a view for each point: planned for some, interpolated linearly between them.
std::vector<PlannedView> find_gazes(const SurfaceTracer& tracer,
                                    const std::vector<Vector3d>& points, const Plan& plan,
                                    double turn_deg) {
  constexpr double kLookAgain = 0.5;  // s, least time between planned views
  const double turn_rate = turn_deg * std::numbers::pi / 180;
  const double interval = std::max(kLookAgain, least_turn() / turn_rate);
  const auto stride = static_cast<std::size_t>(std::ceil(interval / plan.step));
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < points.size() + stride; i += stride) {
    places.push_back(points[std::min(i, points.size() - 1)]);
  }
  const double max_turn = turn_rate * plan.step * static_cast<double>(stride);
  constexpr double kReach = 2.5;  // in units of the scale
  const std::vector<PlannedView> keys =
      plan_views(tracer, places, {.reach = kReach * plan.scale, .max_turn = max_turn});
  std::vector<PlannedView> views;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlannedView& a = keys[i / stride];
    const PlannedView& b = keys[i / stride + 1];
    const double share = static_cast<double>(i % stride) / static_cast<double>(stride);
    views.push_back({a.yaw + share * (b.yaw - a.yaw), a.pitch + share * (b.pitch - a.pitch)});
  }
  return views;
}

/// Returns the least clearance along the path, m, or twice the plan's where that is less.
double least_clearance(const FreeSpace& space, const RestSpline<5>& spline, const Plan& plan) {
  constexpr int kPerStep = 8;
  double least = 2 * plan.clearance;
  const int samples = static_cast<int>(kPerStep * spline.duration() / plan.step);
  for (int i = 0; i <= samples; ++i) {
    const Vector5d state = spline.at(plan.step * i / kPerStep);
    least = std::min(least, space.clearance(state.head<3>(), least));
  }
  return least;
}

}  // namespace

void ExploreOptions::validate() const {
  for (const auto& [name, value] : {std::pair{"length", length}, std::pair{"speed", speed},
                                    std::pair{"clearance", clearance}}) {
    vo::require(value >= 0 && std::isfinite(value), "explore.", name, ": expected 0 or above, got ",
                value);
  }
  constexpr double kSlowest = 0.01;  // deg/s
  constexpr double kFastest = 1e4;   // deg/s
  vo::require(turn_deg >= kSlowest && turn_deg <= kFastest, "explore.turn_deg: expected from ",
              kSlowest, " to ", kFastest, " deg/s, got ", turn_deg);
}

ExploredPath explore(const SurfaceTracer& tracer, double duration_s,
                     const ExploreOptions& options) {
  options.validate();
  const FreeSpace space(tracer);
  const ExploredRegion region = find_region(space, options.seed);
  const Plan plan = make_plan(options, region.scale, duration_s);
  const std::vector<Vector3d> points = find_way(space, region, plan, options.seed);
  const std::vector<PlannedView> views = find_gazes(tracer, points, plan, options.turn_deg);
  std::vector<Vector5d> controls;
  for (std::size_t i = 0; i < points.size(); ++i) {
    controls.emplace_back();
    controls.back() << points[i], views[i].yaw, views[i].pitch;
  }
  const RestSpline<5> spline(controls, plan.step);
  const double clearance = least_clearance(space, spline, plan);
  vo::require(clearance >= plan.clearance * (1 - 1e-6),
              "explore: found no way with a clearance of ", plan.clearance, " m; got ", clearance);
  return {.path =
              [spline](double time) {
                const Vector5d state = spline.at(time);
                const Vector3d eye = state.head<3>();
                const PlannedView view{state[3], state[4]};
                return vo::look_at(eye, eye + view.direction(), Vector3d::UnitY());
              },
          .duration = spline.duration(),
          .speed = plan.spacing / plan.step,
          .clearance = clearance};
}

}  // namespace synth
