#include "vo/odometry.h"

#include <chrono>

#include "vo/core/error.h"

namespace vo {
namespace {

/// Milliseconds since it was made or last asked.
class LapTimer {
 public:
  double lap_ms() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> lap = now - start_;
    start_ = now;
    return lap.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

TrackerOptions preset_options(TrackerPreset preset) {
  TrackerOptions options;
  if (preset == TrackerPreset::paper) {
    options.pyramid.levels = 3;
    options.edges.threshold = EdgeThreshold::otsu;
    options.points.source = EdgeSource::current;
    options.keyframes.every = 1;
    options.lens = LensModel::ignore;
  }
  return options;
}

RgbdOdometry::RgbdOdometry(const PinholeCamera& camera, const TrackerOptions& options,
                           const SE3& T_world_first)
    : camera_(options.lens == LensModel::ignore ? camera.without_distortion() : camera),
      options_(options),
      tracker_(options, T_world_first) {
  camera.validate();
}

TrackingResult RgbdOdometry::track(const RgbdFrame& frame) {
  const cv::Size expected(camera_.width, camera_.height);
  require(frame.image.size() == expected && frame.depth.size() == expected,
          "odometry: expected image and depth of the camera's ", camera_.width, "x", camera_.height,
          " px");
  LapTimer timer;
  current_ = build_pyramid(frame, camera_, options_.pyramid);
  stage_times_.pyramid_ms = timer.lap_ms();
  add_edges(current_, options_.edges);
  stage_times_.edges_ms = timer.lap_ms();

  TrackingResult result = tracker_.track(current_);
  stage_times_.alignment_ms = timer.lap_ms();
  if (tracker_.needs_keyframe(current_, result)) {
    tracker_.set_keyframe(current_, result.T_world_camera);
    result.is_keyframe = true;
  }
  if (result.status != TrackingStatus::lost) {
    trajectory_.push_back({frame.timestamp, result.T_world_camera});
  }
  return result;
}

}  // namespace vo
