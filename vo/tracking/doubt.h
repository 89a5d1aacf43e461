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

/// Says what the surfaces of a view do: how much of them moves by itself, and how much is covered.
struct ViewSurfaces {
  SurfaceAreas areas;
  double covered_fraction = 0;  ///< share of the view's tiles
};

/// Says whether a pose that was found is to be relied on. A driver that repeats images, a depth
/// image that stands still, something that covers the view, is stuck in it or moves through it:
/// each may leave an alignment with a small covariance and a wrong pose.
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
  int same_depths_ = 0;            ///< frames in a row with other images and the same depth
  RecentMean disagreement_;        ///< share of the points that disagree
  RecentMean moving_area_;         ///< area of moving surfaces over that of static ones
  RecentMean depth_disagreement_;  ///< share of the surfaces that disagree
};

}  // namespace vo
