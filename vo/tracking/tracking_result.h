#pragma once

#include <array>
#include <utility>

#include "vo/alignment/align_result.h"
#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"
#include "vo/image/vignette.h"

namespace vo {

enum class TrackingStatus { initialized, tracked, lost };

constexpr auto enum_names(TrackingStatus) {
  return std::array{std::pair{TrackingStatus::initialized, "initialized"},
                    std::pair{TrackingStatus::tracked, "tracked"},
                    std::pair{TrackingStatus::lost, "lost"}};
}

/// The reason why a frame is lost.
enum class LostReason {
  none,             ///< the frame is not lost
  too_few_points,   ///< too few edge pixels with depth, or too few of them in view
  undetermined,     ///< the points leave a direction of motion undetermined
  out_of_view,      ///< too small a share of the reference is in view
  images_disagree,  ///< the images do not look alike where they were brought to agree
  depths_disagree,  ///< the measured depths differ from those of the reference's surfaces
};

constexpr auto enum_names(LostReason) {
  return std::array{std::pair{LostReason::none, "none"},
                    std::pair{LostReason::too_few_points, "too_few_points"},
                    std::pair{LostReason::undetermined, "undetermined"},
                    std::pair{LostReason::out_of_view, "out_of_view"},
                    std::pair{LostReason::images_disagree, "images_disagree"},
                    std::pair{LostReason::depths_disagree, "depths_disagree"}};
}

struct TrackingResult {
  double timestamp = 0;  ///< s
  SE3 T_world_camera;    ///< the last tracked pose if the frame is lost
  TrackingStatus status = TrackingStatus::lost;
  LostReason reason = LostReason::none;
  bool is_keyframe = false;
  AlignResult alignment;           ///< to the first reference; meaningless when initialized
  double reference_timestamp = 0;  ///< s, timestamp of the first reference
  SE3 T_cur_ref_guess;             ///< pose where the alignment started
  Readout readout;                 ///< rolling shutter's read-out used for this frame
  Vignette vignette;               ///< removed from this frame's intensities
};

}  // namespace vo
