#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/tracking/align.h"

namespace vo {

/// Where the search for the next pose starts.
enum class MotionModel {
  stationary,         ///< at the last pose
  constant_velocity,  ///< at the last pose moved on as between the last two frames
};

constexpr auto enum_names(MotionModel) {
  return std::array{std::pair{MotionModel::stationary, "stationary"},
                    std::pair{MotionModel::constant_velocity, "constant_velocity"}};
}

/// How the lens enters the warp.
enum class LensModel {
  ignore,      ///< as the paper: the pinhole part alone
  distortion,  ///< rays are undistorted and projections distorted; images stay as they are
};

constexpr auto enum_names(LensModel) {
  return std::array{std::pair{LensModel::ignore, "ignore"},
                    std::pair{LensModel::distortion, "distortion"}};
}

struct KeyframeOptions {
  int every = 1;  ///< frames; 1 aligns frame to frame

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, KeyframeOptions& options) {
  visit("every", options.every, "frames from keyframe to keyframe; 1 is frame to frame");
}

/// When an alignment is not believed.
struct LostOptions {
  double min_visible_fraction = 0.4;  ///< of the reference's edge points
  double min_correlation = 0.5;       ///< of the intensities at the visible points

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, LostOptions& options) {
  visit("min_visible_fraction", options.min_visible_fraction,
        "lost below this share of the reference's points in view");
  visit("min_correlation", options.min_correlation,
        "lost below this correlation of the intensities at the visible points");
}

struct TrackerOptions {
  PyramidOptions pyramid;
  EdgeOptions edges;
  EdgePointOptions points;
  AlignOptions align;
  KeyframeOptions keyframes;
  LostOptions lost;
  MotionModel motion_model = MotionModel::constant_velocity;
  LensModel lens = LensModel::distortion;

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, TrackerOptions& options) {
  visit("pyramid", options.pyramid, "");
  visit("edges", options.edges, "");
  visit("points", options.points, "");
  visit("align", options.align, "");
  visit("keyframes", options.keyframes, "");
  visit("lost", options.lost, "");
  visit("motion_model", options.motion_model, "where the search for the next pose starts");
  visit("lens", options.lens, "how lens distortion enters the warp");
}

enum class TrackingStatus { initialized, tracked, lost };

constexpr auto enum_names(TrackingStatus) {
  return std::array{std::pair{TrackingStatus::initialized, "initialized"},
                    std::pair{TrackingStatus::tracked, "tracked"},
                    std::pair{TrackingStatus::lost, "lost"}};
}

struct TrackingResult {
  double timestamp = 0;  ///< s
  SE3 T_world_camera;    ///< the last tracked pose when lost
  TrackingStatus status = TrackingStatus::lost;
  bool is_keyframe = false;
  AlignResult alignment;  ///< to the reference; meaningless when initialized
  SE3 T_cur_ref_guess;    ///< where the alignment started
};

/// Tracks frames against a reference frame. Knows nothing of where the reference's depth came from.
class Tracker {
 public:
  explicit Tracker(const TrackerOptions& options, SE3 T_world_first = {});

  /// The first frame with enough edge pixels that have depth starts the reference at T_world_first;
  /// frames before it are lost. After a lost frame the motion model starts again from rest.
  TrackingResult track(const FramePyramid& current);

  /// Whether the frame of this result should become the reference: it is time for one, and the
  /// frame has enough edge pixels with depth to be one.
  bool needs_keyframe(const FramePyramid& current, const TrackingResult& result) const;
  void set_keyframe(const FramePyramid& keyframe, const SE3& T_world_keyframe);

  /// The reference's points as they were aligned to the last frame; for pictures and tests.
  const EdgePoints& reference_points() const { return reference_points_; }

 private:
  SE3 predicted_T_world_camera() const;
  void update_motion(const SE3& T_world_current);
  bool can_be_reference(const FramePyramid& frame) const;

  TrackerOptions options_;
  std::optional<FramePyramid> reference_;
  EdgePoints reference_points_;
  bool reference_is_new_ = true;
  int frames_since_keyframe_ = 0;
  SE3 T_world_reference_;
  SE3 T_world_last_;
  SE3 T_last_predicted_;  ///< motion since the last frame, by the motion model
  bool was_lost_ = false;
};

}  // namespace vo
