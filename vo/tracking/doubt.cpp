#include "vo/tracking/doubt.h"

#include <algorithm>

namespace vo {
namespace {

/// Frames with the same depth that a sensor may give whose depth is slower than its images.
constexpr int kSlowDepth = 5;

/// Share of the points in parts that disagree: of one frame, and as a mean over some. On real and
/// rendered sequences of a rigid world one frame in a hundred has more than 0.07.
constexpr double kMostDisagreement = 0.15;
constexpr double kMostMeanDisagreement = 0.07;

/// Share of the reference's surfaces that are not measured where they would be seen, as a mean.
/// Nine of ten frames of a rigid world have less than 0.05, one in a hundred 0.27.
constexpr double kMostDepthDisagreement = 0.3;

/// Difference of the depths from those of the reference, beyond noise, in one frame and as a mean.
/// In a rigid world it is 0.02 and 0.01 at most, on real and on rendered sequences.
constexpr double kMostDepthDeviation = 0.04;
constexpr double kMostMeanDepthDeviation = 0.016;

/// Area of the surfaces that move over that of the static ones, in one frame and as a mean, from
/// which on it is not clear which of them is the world. Sequences of a rigid world have 0.3 at
/// most, and 0.17 in the mean.
constexpr double kCompetingArea = 0.55;
constexpr double kCompetingMeanArea = 0.42;

/// Share of the view that may be black.
constexpr double kMostCovered = 0.3;

/// Share of noise in the curvature of the loss along the direction of motion that has the most: of
/// one frame, and as a mean over some by how much it exceeds a half. Parallel stripes have 0.5 to
/// 1; a hand-held camera in a room has 0.1, and 0.5 in one frame of a hundred. Where nothing
/// else spoke against a pose in a room, means were 0.01 above a half at most.
constexpr double kMostNoise = 0.9;
constexpr double kNoiseBeyondHalf = 0.1;

/// Standard deviation of the position relative to the reference, over the depth of its points. It
/// is above 0.003 in one frame of ten and above 0.01 in one of a thousand where depth is measured
/// in much of the view.
constexpr double kMostDeviation = 0.01;

constexpr double kNewest = 0.2;  // weight of a frame in the means

}  // namespace

void Doubt::see(const FramePyramid& frame) {
  image_is_repeated_ = frame.image_fingerprint == image_ && frame.image_fingerprint != 0;
  const bool same_depth = frame.depth_fingerprint == depth_ && frame.depth_fingerprint != 0;
  same_depths_ = same_depth && !image_is_repeated_ ? same_depths_ + 1 : 0;
  image_ = frame.image_fingerprint;
  depth_ = frame.depth_fingerprint;
}

void RecentMean::add(double value, double limit) {
  mean += kNewest * (value - mean);
  is_high = mean > (is_high ? limit / 2 : limit);
}

bool CompetingMotions::add(const SurfaceAreas& areas) {
  frames_ += 1;
  const double weight = std::max(kNewest, 1 / frames_);
  mean_.of_static += weight * (areas.of_static - mean_.of_static);
  mean_.of_moving += weight * (areas.of_moving - mean_.of_moving);
  most_moving_ = goes_on_ ? std::max(most_moving_, mean_.of_moving) : mean_.of_moving;
  goes_on_ = most_moving_ > kCompetingMeanArea * mean_.of_static;
  return goes_on_ || areas.moving_ratio() > kCompetingArea;
}

TrackingReason Doubt::judge(const AlignResult& alignment, const ViewSurfaces& surfaces) {
  const double disagreement = alignment.agreement.disagreeing_fraction;
  disagreement_.add(disagreement, kMostMeanDisagreement);
  depth_disagreement_.add(1 - alignment.depth_agreement, kMostDepthDisagreement);
  noise_.add(alignment.noise_share - 0.5, kNoiseBeyondHalf);
  depth_deviation_.add(surfaces.depth_deviation, kMostMeanDepthDeviation);
  const bool motions_compete = motions_.add(surfaces.edged);
  if (image_is_repeated_) {
    return TrackingReason::image_repeated;
  }
  if (same_depths_ > kSlowDepth) {
    return TrackingReason::depth_repeated;
  }
  if (surfaces.covered_fraction > kMostCovered) {
    return TrackingReason::view_covered;
  }
  if (motions_compete || surfaces.changed_motion) {
    return TrackingReason::two_motions;
  }
  if (disagreement > kMostDisagreement || disagreement_.is_high) {
    return TrackingReason::parts_disagree;
  }
  if (depth_disagreement_.is_high || depth_deviation_.is_high ||
      surfaces.depth_deviation > kMostDepthDeviation) {
    return TrackingReason::depths_disagree;
  }
  const bool is_vague = alignment.position_deviation() > kMostDeviation;
  return alignment.noise_share > kMostNoise || noise_.is_high || is_vague
             ? TrackingReason::undetermined
             : TrackingReason::none;
}

}  // namespace vo
