#include "tools/point_cloud/keyframe_cloud.h"

#include <algorithm>
#include <utility>

#include "vo/tracking/tracker.h"

namespace tools {
namespace {

bool holds(const std::deque<std::shared_ptr<const vo::Keyframe>>& keyframes, double timestamp) {
  return std::any_of(keyframes.begin(), keyframes.end(), [&](const auto& keyframe) {
    return keyframe->pyramid.timestamp == timestamp;
  });
}

}  // namespace

EdgeCloud points_of(const vo::Keyframe& keyframe) {
  const vo::EdgePointLevel& level = keyframe.points->levels.front();
  EdgeCloud cloud(level.size());
  for (std::size_t i = 0; i < level.size(); ++i) {
    const float z = level.z_ref[i];
    const Eigen::Vector3d p_keyframe(level.x_ref[i], level.y_ref[i], z);
    cloud[i] = {.p_world = (keyframe.T_world_keyframe * p_keyframe).cast<float>(),
                .grey = grey_of(level.intensity[i]),
                .inverse_depth_sigma = level.depth_sigma[i] / (z * z)};
  }
  return cloud;
}

vo::FrameObserver KeyframeCloud::observer(vo::FrameObserver other) {
  return
      [this, other = std::move(other)](const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                                       const vo::Tracker& tracker, const vo::TrackingResult& result,
                                       const vo::StageTimes& times) {
        observe(tracker.map());
        if (other) {
          other(frame, pyramid, tracker, result, times);
        }
      };
}

vo::MonoObserver KeyframeCloud::mono_observer() {
  return [this](const vo::RgbdFrame& frame, const vo::MonoOdometry& odometry,
                const vo::MonoResult& result) {
    if (result.state == vo::MonoState::reinitialising) {
      first_of_map_ = frame.timestamp;
    }
    if (result.joins_maps) {
      leave_out_last_map();
    }
    if (vo::is_in_map(result.state)) {
      observe(odometry.tracker().map());
    }
  };
}

/// Takes the points of the keyframes that the tracker has forgotten since the call before.
void KeyframeCloud::observe(const vo::LocalMap& map) {
  for (const auto& keyframe : held_) {
    if (!holds(map.keyframes(), keyframe->pyramid.timestamp)) {
      take(*keyframe);
    }
  }
  held_ = map.keyframes();
}

void KeyframeCloud::leave_out_last_map() {
  taken_.erase(taken_.lower_bound(first_of_map_), taken_.end());
  held_.clear();
}

EdgeCloud KeyframeCloud::finish() {
  for (const auto& keyframe : held_) {
    take(*keyframe);
  }
  held_.clear();
  EdgeCloud cloud;
  for (const auto& [timestamp, points] : std::exchange(taken_, {})) {
    cloud.insert(cloud.end(), points.begin(), points.end());
  }
  return cloud;
}

void KeyframeCloud::take(const vo::Keyframe& keyframe) {
  taken_[keyframe.pyramid.timestamp] = points_of(keyframe);
}

}  // namespace tools
