#include <algorithm>
#include <utility>

#include "vo/tracking/image_motion.h"
#include "vo/tracking/sharpness.h"
#include "vo/tracking/tracker.h"

/// This file holds when the tracker makes a keyframe, and of what.
namespace vo {
namespace {

/// Share of the last or the nearest keyframe's points in view; with less a keyframe is due.
constexpr double kKeyframeOverlap = 0.75;

/// Correlation of an alignment; with less a keyframe waits.
constexpr double kKeyframeCorrelation = 0;

}  // namespace

bool Tracker::needs_keyframe(const FramePyramid& current, const TrackingResult& result) const {
  if (result.status == TrackingStatus::initialized) {
    return true;
  }
  if (result.status == TrackingStatus::lost || !can_be_reference(current)) {
    return false;
  }
  const KeyframeOptions& options = options_.keyframes;
  if (options.every > 0) {
    return frames_since_keyframe_ >= options.every;
  }
  const SE3 T_cur_last = result.T_world_camera.inverse() * map_.last()->T_world_keyframe;
  const ImageMotion motion = image_motion(*map_.last()->points, current, T_cur_last);
  const double flow = motion.flow_px / current.levels.front().camera.width;
  const double overlap = std::min(motion.overlap, result.alignment.visible_fraction);
  if (flow <= options.max_flow && overlap >= kKeyframeOverlap) {
    return false;
  }
  constexpr double kLongestWait = 2;  // times the due keyframe's flow, for a sharp frame
  const bool urgent = flow > kLongestWait * options.max_flow || overlap < options_.map.min_overlap;
  return urgent ||
         (agrees_with_map(result) && result.alignment.correlation >= kKeyframeCorrelation &&
          !is_blurred(current, T_cur_last));
}

/// Returns whether the frame is too blurred relative to the last keyframe, where both show the
/// same.
bool Tracker::is_blurred(const FramePyramid& current, const SE3& T_cur_last) const {
  if (current_points_ == nullptr) {
    return false;
  }
  const Keyframe& last = *map_.last();
  std::shared_ptr<const EdgePoints> points = current_points_;
  if (last.is_disturbed()) {
    EdgePoints still = *current_points_;
    leave_out({grown(last.moved), last.pyramid, T_cur_last.inverse()}, still);
    points = std::make_shared<const EdgePoints>(std::move(still));
  }
  return relative_sharpness({last.points->levels.front(), last.pyramid.levels.front()},
                            {points->levels.front(), current.levels.front()},
                            T_cur_last) < options_.keyframes.min_sharpness;
}

void Tracker::set_keyframe(const FramePyramid& keyframe, const SE3& T_world_keyframe) {
  if (current_points_ == nullptr) {
    find_current_points(keyframe);
  } else if (is_segmenting()) {
    use_points_outside(unusable(grown(segmentation_.moving())), keyframe);
  }
  set_keyframe(keyframe, T_world_keyframe,
               options_.symmetric ? current_points_ : std::exchange(current_points_, nullptr));
}

/// Returns the window's frames, those that are moved first. At least one is held: the oldest.
std::vector<WindowFrame> Tracker::window(const std::vector<std::size_t>& keyframes) const {
  const auto moved = static_cast<std::size_t>(options_.window.moved);
  const std::size_t oldest = *std::min_element(keyframes.begin(), keyframes.end());
  std::vector<WindowFrame> frames;
  for (const std::size_t k : keyframes) {
    const Keyframe& keyframe = *map_.keyframes()[k];
    const bool held = frames.size() >= moved || (keyframes.size() <= moved && k == oldest);
    frames.push_back({.image = &keyframe.pyramid.levels.front(),
                      .points = keyframe.points->levels.front(),
                      .measured_depth = keyframe.measured_depth,
                      .T_frame_world = keyframe.T_world_keyframe.inverse(),
                      .velocity = keyframe.velocity.value_or(FrameVelocity()),
                      .held = held});
  }
  return frames;
}

/// Adjusts the keyframes around the newest, which is the last tracked frame.
void Tracker::adjust_keyframes() {
  const int count = options_.window.moved + options_.window.held;
  const std::vector<std::size_t> keyframes = map_.around_last(static_cast<std::size_t>(count));
  if (keyframes.size() < 2) {
    return;
  }
  std::vector<WindowFrame> frames = window(keyframes);
  adjust_window(frames, options_.window, align_options());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    map_.adjust(keyframes[n], frames[n].T_frame_world.inverse(), std::move(frames[n].points));
  }
  T_world_last_ = map_.last()->T_world_keyframe;
}

void Tracker::set_keyframe(const FramePyramid& keyframe, const SE3& T_world_keyframe,
                           std::shared_ptr<const EdgePoints> points) {
  std::shared_ptr<SurfacePoints> surface;
  if (options_.align.depth_term > 0 && !keyframe.levels.front().depth.empty()) {
    surface =
        std::make_shared<SurfacePoints>(surface_points(keyframe.levels[surface_level(keyframe)]));
    if (segmentation_.moving().any()) {
      leave_out(grown(segmentation_.moving()), keyframe, *surface);
    }
  }
  std::vector<float> measured_depth;
  if (options_.window.adjust == WindowAdjustment::depth) {
    measured_depth = points->levels.front().z_ref;
  }
  map_.add({keyframe, std::move(points), T_world_keyframe, velocity_, std::move(surface),
            std::move(measured_depth), readout(), segmentation_.moving(), absolute_covariance_,
            is_uncertain_});
  frames_since_keyframe_ = 0;
  if (options_.window.adjust != WindowAdjustment::none) {
    adjust_keyframes();
  }
}

void Tracker::update_keyframe(std::shared_ptr<const EdgePoints> points) {
  map_.set_last_points(std::move(points));
  depth_is_mapped_ = true;
}

bool Tracker::can_be_reference(const FramePyramid& frame) const {
  return has_edge_pixels_with_depth(
      frame.levels.front(), static_cast<std::size_t>(options_.align.min_points), options_.points);
}

}  // namespace vo
