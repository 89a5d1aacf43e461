#pragma once

#include <cstdint>

#include "vo/alignment/align_result.h"
#include "vo/image/pyramid.h"
#include "vo/segmentation/tile_surfaces.h"
#include "vo/tracking/tracking_result.h"

namespace vo {

/// Holds the mean of a share over the last frames, and whether it is too high: from when it exceeds
/// the limit until it falls below half of it.
struct RecentMean {
  double mean = 0;
  bool is_high = false;

  void add(double value, double limit);
};

/// Says whether two motions compete for being the camera's: much of what the view shows moves by
/// itself if the pose is right, and would be the world if the pose followed the other motion.
///
/// Once begun, a competition lasts until far more is static than has moved since. What moves is
/// taken out of the keyframes and may leave the view; the silence that follows does not say that
/// the right motion was chosen.
class CompetingMotions {
 public:
  /// Takes in the areas of the next frame's surfaces, and returns whether motions compete in it.
  bool add(const SurfaceAreas& areas);

 private:
  double frames_ = 0;
  SurfaceAreas mean_;       ///< over the last frames
  double most_moving_ = 0;  ///< greatest mean area of what moves since the competition began
  bool goes_on_ = false;
};

/// Says what the surfaces of a view do: how much of them moves by itself, and how much is covered.
struct ViewSurfaces {
  SurfaceAreas edged;           ///< of the tiles with edge points, which tell motions apart
  double covered_fraction = 0;  ///< share of the view's tiles
  bool changed_motion = false;  ///< whether another motion was found to be the camera's
  double depth_deviation = 0;   ///< from the first reference's depths; see depth_deviation()
};

/// Returns whether what the frame shows agrees with the map: nothing speaks against its pose, or
/// only that noise determines it, or that the map itself is uncertain. Such a frame goes on as one
/// that is sure, since no frame after it would see more of the direction that is missing, or tell
/// where the map lies.
inline bool agrees_with_map(const TrackingResult& result) {
  return result.status == TrackingStatus::tracked ||
         (result.status == TrackingStatus::uncertain &&
          (result.reason == TrackingReason::undetermined ||
           result.reason == TrackingReason::map_uncertain));
}

/// Says whether a pose that was found is to be relied on. A driver that repeats images, a depth
/// image that stands still, something that covers the view, is stuck in it or moves through it,
/// noise that determines a motion along which nothing changes: each may leave an alignment with a
/// small covariance and a wrong pose.
class Doubt {
 public:
  /// Takes in the fingerprints of the next frame's images, before it is aligned; 0 says nothing.
  void see(const FramePyramid& frame);

  /// Takes in the alignment of the frame seen last and what its surfaces do, and returns why its
  /// pose is uncertain, or none.
  TrackingReason judge(const AlignResult& alignment, const ViewSurfaces& surfaces);

 private:
  std::uint64_t image_ = 0;
  std::uint64_t depth_ = 0;
  bool image_is_repeated_ = false;
  int same_depths_ = 0;      ///< frames in a row with other images and the same depth
  RecentMean noise_;         ///< share of noise in the curvature, less a half
  RecentMean disagreement_;  ///< share of the points that disagree
  CompetingMotions motions_;
  RecentMean depth_disagreement_;  ///< share of the surfaces that disagree
  RecentMean depth_deviation_;     ///< difference of the depths beyond noise
};

}  // namespace vo
