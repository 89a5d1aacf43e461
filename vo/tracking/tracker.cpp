#include "vo/tracking/tracker.h"

#include <utility>

#include "vo/core/error.h"

namespace vo {

void KeyframeOptions::validate() const {
  require(every >= 1, "keyframes.every: expected at least 1, got ", every);
}

void LostOptions::validate() const {
  require(min_visible_fraction >= 0 && min_visible_fraction <= 1,
          "lost.min_visible_fraction: expected 0 to 1, got ", min_visible_fraction);
  require(min_correlation >= -1 && min_correlation <= 1,
          "lost.min_correlation: expected -1 to 1, got ", min_correlation);
}

void TrackerOptions::validate() const {
  pyramid.validate();
  edges.validate();
  points.validate();
  align.validate();
  keyframes.validate();
  lost.validate();
}

Tracker::Tracker(const TrackerOptions& options, SE3 T_world_first)
    : options_(options), T_world_last_(std::move(T_world_first)) {
  options_.validate();
}

TrackingResult Tracker::track(const FramePyramid& current) {
  TrackingResult result{.timestamp = current.timestamp, .T_world_camera = T_world_last_};
  if (!reference_) {
    result.status = can_be_reference(current) ? TrackingStatus::initialized : TrackingStatus::lost;
    return result;
  }
  if (options_.points.source != EdgeSource::reference || reference_is_new_) {
    reference_points_ = edge_points(*reference_, current, options_.points);
    reference_is_new_ = false;
  }
  result.T_cur_ref_guess = predicted_T_world_camera().inverse() * T_world_reference_;
  result.alignment = align(reference_points_, current, result.T_cur_ref_guess, options_.align);
  ++frames_since_keyframe_;

  const AlignResult& alignment = result.alignment;
  const bool believed = alignment.usable() &&
                        alignment.visible_fraction >= options_.lost.min_visible_fraction &&
                        alignment.correlation >= options_.lost.min_correlation;
  if (believed) {
    result.status = TrackingStatus::tracked;
    result.T_world_camera = T_world_reference_ * alignment.T_cur_ref.inverse();
    update_motion(result.T_world_camera);
  } else {
    T_last_predicted_ = SE3();
    was_lost_ = true;
  }
  return result;
}

bool Tracker::needs_keyframe(const FramePyramid& current, const TrackingResult& result) const {
  return result.status == TrackingStatus::initialized ||
         (result.status == TrackingStatus::tracked &&
          frames_since_keyframe_ >= options_.keyframes.every && can_be_reference(current));
}

void Tracker::set_keyframe(const FramePyramid& keyframe, const SE3& T_world_keyframe) {
  reference_ = keyframe;
  reference_is_new_ = true;
  T_world_reference_ = T_world_keyframe;
  frames_since_keyframe_ = 0;
}

SE3 Tracker::predicted_T_world_camera() const {
  return T_world_last_ * T_last_predicted_;
}

void Tracker::update_motion(const SE3& T_world_current) {
  if (options_.motion_model == MotionModel::constant_velocity && !was_lost_) {
    T_last_predicted_ = T_world_last_.inverse() * T_world_current;
  }
  T_world_last_ = T_world_current;
  was_lost_ = false;
}

bool Tracker::can_be_reference(const FramePyramid& frame) const {
  return edge_pixels_with_depth(frame.levels.front(), options_.points) >=
         static_cast<std::size_t>(options_.align.min_points);
}

}  // namespace vo
