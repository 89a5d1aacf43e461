#pragma once

#include <array>
#include <utility>

#include "vo/alignment/align_result.h"
#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"
#include "vo/image/vignette.h"

namespace vo {

enum class TrackingStatus {
  initialized,  ///< a frame that the map begins with, where the trajectory starts
  tracked,
  uncertain,  ///< the frame has a pose that must not be relied on
  lost,       ///< the frame has no pose
};

constexpr auto enum_names(TrackingStatus) {
  return std::array{std::pair{TrackingStatus::initialized, "initialized"},
                    std::pair{TrackingStatus::tracked, "tracked"},
                    std::pair{TrackingStatus::uncertain, "uncertain"},
                    std::pair{TrackingStatus::lost, "lost"}};
}

/// The reason why a frame is lost or uncertain.
enum class TrackingReason {
  none,             ///< the frame is neither
  too_few_points,   ///< too few edge pixels with depth, or too few of them in view
  undetermined,     ///< the points leave a direction of motion undetermined or determine it vaguely
  out_of_view,      ///< too small a share of the reference is in view
  images_disagree,  ///< the images do not look alike where they were brought to agree
  depths_disagree,  ///< the measured depths differ from those of the reference's surfaces
  image_repeated,   ///< the image is the one before, byte for byte, under another stamp
  depth_repeated,   ///< the depth has stood still for many frames, the image has not
  parts_disagree,   ///< parts of the view show something else than the rest of it lets expect
  two_motions,      ///< two parts of the view move differently, and neither is clearly the world
  view_covered,     ///< much of the image is black where depths are measured
  map_uncertain,    ///< all keyframes that the frame is aligned to are uncertain themselves
};

constexpr auto enum_names(TrackingReason) {
  return std::array{std::pair{TrackingReason::none, "none"},
                    std::pair{TrackingReason::too_few_points, "too_few_points"},
                    std::pair{TrackingReason::undetermined, "undetermined"},
                    std::pair{TrackingReason::out_of_view, "out_of_view"},
                    std::pair{TrackingReason::images_disagree, "images_disagree"},
                    std::pair{TrackingReason::depths_disagree, "depths_disagree"},
                    std::pair{TrackingReason::image_repeated, "image_repeated"},
                    std::pair{TrackingReason::depth_repeated, "depth_repeated"},
                    std::pair{TrackingReason::parts_disagree, "parts_disagree"},
                    std::pair{TrackingReason::two_motions, "two_motions"},
                    std::pair{TrackingReason::view_covered, "view_covered"},
                    std::pair{TrackingReason::map_uncertain, "map_uncertain"}};
}

struct TrackingResult {
  double timestamp = 0;  ///< s
  SE3 T_world_camera;    ///< the last tracked pose if the frame is lost
  TrackingStatus status = TrackingStatus::lost;
  TrackingReason reason = TrackingReason::none;
  bool is_keyframe = false;
  AlignResult alignment;           ///< to the first reference; meaningless when initialized
  double reference_timestamp = 0;  ///< s, timestamp of the first reference
  SE3 T_cur_ref_guess;             ///< pose where the alignment started

  /// Covariance of the increment delta of T_world_camera exp(delta), [translation; rotation] in the
  /// camera's own frame, m and rad; exp(delta) left of T_camera_world has the same. The frame
  /// that the map began with is the origin, without doubt. It is compounded_covariance() of the
  /// alignment's and the first reference's: that a pose and its reference may err alike, being
  /// aligned to common keyframes, is neglected, and so is what other references know. 0 where there
  /// is no pose but the first.
  Matrix6d absolute_covariance = Matrix6d::Zero();

  /// By how much the depths differ from those of the first reference, depth_deviation(); 0 where
  /// poses are not doubted.
  double depth_deviation = 0;
  double moving_fraction = 0;  ///< share of the view's tiles that move by themselves

  Readout readout;    ///< rolling shutter's read-out used for this frame
  Vignette vignette;  ///< removed from this frame's intensities
};

}  // namespace vo
