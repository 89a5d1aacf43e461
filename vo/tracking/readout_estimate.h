#pragma once

#include "vo/alignment/align_result.h"

namespace vo {

/// Estimates the read-out time of a rolling shutter while tracking: the one at which the frames
/// agree best. A wrong one bends every image that is taken in motion; 10 ms at 20 deg/s is 1.7 px
/// between the first and the last row of a Kinect's image.
///
/// Every frame gives the derivatives of its minimal cost by the read-out time. Their quadratic
/// models are summed, starting from a prior that holds the time at its first value.
class ReadoutEstimate {
 public:
  explicit ReadoutEstimate(double first_s);

  double seconds() const;

  /// Adds the loss of a frame that was aligned with this read-out time, s. `curvature_share` is the
  /// share of the loss's curvature that is left when the points' depths follow the read-out time.
  void update(const LossByReadout& loss, double readout_s, double curvature_share = 1);

 private:
  double information_;  ///< 1/s^2
  double weighted_;     ///< information times the estimate, 1/s
};

}  // namespace vo
