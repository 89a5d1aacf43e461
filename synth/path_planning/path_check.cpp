#include "synth/path_planning/path_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "synth/path_planning/free_space.h"
#include "synth/path_planning/moving_obstacles.h"
#include "synth/path_planning/view_content.h"
#include "synth/ray_tracing/surface_tracer.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene_motion.h"
#include "vo/core/error.h"
#include "vo/core/median.h"

namespace synth {
namespace {

constexpr int kBetweenFrames = 8;
constexpr double kTouch = 1e-3;        // m, clearance below which it is a collision
constexpr double kBlank = 0.05;        // share of textured tiles below which a view is blank
constexpr double kDifference = 0.005;  // s, step to either side of central differences

/// The scene at an instant, with a tracer and a free space that refer to it.
struct Instant {
  explicit Instant(Scene now)
      : scene(std::move(now)), tracer(scene, RenderOptions{}.ambient), space(tracer) {}

  Scene scene;
  SurfaceTracer tracer;
  FreeSpace space;
};

double clearance_between(const FreeSpace& space, const CameraPath& path, double from, double to) {
  double least = space.bounds().diagonal().norm();
  Eigen::Vector3d last = path(from).translation();
  for (int i = 0; i <= kBetweenFrames; ++i) {
    const Eigen::Vector3d here = path(from + (to - from) * i / kBetweenFrames).translation();
    least = space.is_crossed(last, here) ? 0 : std::min(least, space.clearance(here, least));
    last = here;
  }
  return least;
}

void measure_motion(const CameraPath& path, FrameCheck& frame) {
  const vo::SE3 before = path(frame.time - kDifference);
  const vo::SE3 here = path(frame.time);
  const vo::SE3 after = path(frame.time + kDifference);
  const Eigen::Vector3d step = after.translation() - before.translation();
  frame.speed = step.norm() / (2 * kDifference);
  frame.turn_deg = (before.inverse() * after).angle() / (2 * kDifference) * 180 / std::numbers::pi;
  frame.acceleration =
      (before.translation() - 2 * here.translation() + after.translation()).norm() /
      (kDifference * kDifference);
}

/// Returns the median optical flow by the camera's motion alone, in pixels of `camera`.
double median_flow(const SurfaceTracer& tracer, const vo::CameraModel& camera,
                   const vo::SE3& T_world_cur, const vo::SE3& T_world_next) {
  const vo::CameraModel small = thumbnail(camera, 64);
  const vo::DepthImage depth = tracer.trace(small, T_world_cur).depth;
  const vo::SE3 T_next_cur = T_world_next.inverse() * T_world_cur;
  std::vector<double> flows;
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const Eigen::Vector3d p_cur = static_cast<double>(depth(v, u)) * small.ray({u, v});
      const Eigen::Vector3d p_next = T_next_cur * p_cur;
      if (camera.depth(p_cur) > 0 && camera.depth(p_next) > 0) {
        flows.push_back(camera.displacement(camera.project(p_cur), camera.project(p_next)).norm());
      }
    }
  }
  return vo::upper_median(std::move(flows));
}

void measure_view(const SurfaceTracer& tracer, const vo::CameraModel& camera,
                  const vo::SE3& T_world_camera, FrameCheck& frame) {
  const double everywhere = 2 * tracer.bounds().diagonal().norm();
  const ViewContent content =
      view_content(tracer, thumbnail(camera, 64), T_world_camera, everywhere);
  frame.depth_share = content.depth_share;
  frame.textured_share = content.textured_share;
}

/// Checks frames of a path, from any thread. What it is given must outlive it.
class FrameChecker {
 public:
  FrameChecker(const Scene& scene, const vo::CameraModel& camera, const TimedPath& timed)
      : scene_(scene), camera_(camera), timed_(timed), moving_(moving_instances(scene)) {
    if (!moves(scene)) {
      still_ = std::make_shared<const Instant>(scene_at(scene, 0));
    }
  }

  /// Returns the scene as it is at a frame.
  std::shared_ptr<const Instant> instant(std::size_t frame) const {
    return still_ ? still_
                  : std::make_shared<const Instant>(
                        scene_at(scene_, timed_.times[frame] - timed_.times.front()));
  }

  /// Checks a frame and the way to the next one. `now` is the scene at the frame, and then that at
  /// the next one.
  FrameCheck check(std::size_t index, std::shared_ptr<const Instant>& now) const {
    const std::size_t next_index = std::min(index + 1, timed_.times.size() - 1);
    FrameCheck frame{.time = timed_.times[index]};
    const double next = timed_.times[next_index];
    const vo::SE3 T_world_cur = timed_.path(frame.time);
    const vo::SE3 T_world_next = timed_.path(next);
    measure_motion(timed_.path, frame);
    measure_view(now->tracer, camera_, T_world_cur, frame);
    frame.clearance = clearance_between(now->space, timed_.path, frame.time, next);
    frame.flow_px = median_flow(now->tracer, camera_, T_world_cur, T_world_next);
    if (!still_) {
      std::shared_ptr<const Instant> then = instant(next_index);
      if (is_struck(now->scene, then->scene, moving_,
                    {T_world_cur.translation(), T_world_next.translation()})) {
        frame.clearance = 0;
      }
      now = std::move(then);
    }
    return frame;
  }

 private:
  const Scene& scene_;
  const vo::CameraModel& camera_;
  const TimedPath& timed_;
  std::vector<bool> moving_;
  std::shared_ptr<const Instant> still_;  ///< where nothing moves
};

void require_limits(const PathLimits& limits, PathReport& report) {
  const auto compare = [&](const char* name, double found, double limit, bool is_kept) {
    if (limit > 0 && !is_kept) {
      report.violations.push_back(vo::concat(name, ": got ", found, ", limit ", limit));
    }
  };
  const auto at_least = [&](const char* name, double FrameCheck::*value, double limit) {
    const double found = range_of(report.frames, value).min;
    compare(name, found, limit, found >= limit);
  };
  const auto at_most = [&](const char* name, double FrameCheck::*value, double limit) {
    const double found = range_of(report.frames, value).max;
    compare(name, found, limit, found <= limit);
  };
  at_least("min_clearance", &FrameCheck::clearance, limits.min_clearance);
  at_least("min_depth_share", &FrameCheck::depth_share, limits.min_depth_share);
  at_least("min_textured_share", &FrameCheck::textured_share, limits.min_textured_share);
  at_most("max_speed", &FrameCheck::speed, limits.max_speed);
  at_most("max_turn_deg", &FrameCheck::turn_deg, limits.max_turn_deg);
  at_most("max_acceleration", &FrameCheck::acceleration, limits.max_acceleration);
  at_most("max_flow_px", &FrameCheck::flow_px, limits.max_flow_px);
}

}  // namespace

void PathLimits::validate() const {
  for (const double limit : {min_clearance, min_depth_share, min_textured_share, max_speed,
                             max_turn_deg, max_acceleration, max_flow_px}) {
    vo::require(limit >= 0 && std::isfinite(limit),
                "path check: expected limits of 0 or above, got ", limit);
  }
}

Range range_of(const std::vector<FrameCheck>& frames, double FrameCheck::*value) {
  std::vector<double> values;
  for (const FrameCheck& frame : frames) {
    values.push_back(frame.*value);
  }
  if (values.empty()) {
    return {};
  }
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {*least, vo::upper_median(values), *greatest};
}

std::vector<FrameCheck> check_frames(const Scene& scene, const vo::CameraModel& camera,
                                     const TimedPath& timed, const FrameRange& range) {
  constexpr std::size_t kChunk = 8;  // frames in a row, which share the scene's state between two
  const FrameChecker checker(scene, camera, timed);
  std::vector<FrameCheck> frames(range.end - range.first);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(range.first, range.end, kChunk),
                    [&](const tbb::blocked_range<std::size_t>& chunk) {
                      auto now = checker.instant(chunk.begin());
                      for (std::size_t i = chunk.begin(); i < chunk.end(); ++i) {
                        frames[i - range.first] = checker.check(i, now);
                      }
                    });
  return frames;
}

PathReport check_path(const Scene& scene, const vo::CameraModel& camera, const TimedPath& timed,
                      const PathLimits& limits) {
  limits.validate();
  PathReport report;
  report.frames = check_frames(scene, camera, timed, {0, timed.times.size()});
  for (const FrameCheck& frame : report.frames) {
    report.collisions += frame.clearance < kTouch ? 1 : 0;
    report.blank_views += frame.textured_share < kBlank ? 1 : 0;
  }
  report.length = vo::path_length(sample(timed.path, timed.times));
  report.duration = timed.times.back() - timed.times.front();
  require_limits(limits, report);
  return report;
}

}  // namespace synth
