#pragma once

#include "vo/alignment/align_result.h"

namespace vo {

/// The read-out time of a rolling shutter, found while tracking: the images themselves say at which
/// one the frames agree best. A wrong one bends every image that is taken in motion; 10 ms at 20
/// deg/s is 1.7 px between the first and the last row of a Kinect's.
///
/// Every frame gives the derivatives of its least cost by the read-out time; their quadratic models
/// are summed, starting from one that holds the time at its first value.
class ReadoutEstimate {
 public:
  explicit ReadoutEstimate(double first_s);

  double seconds() const;

  /// Takes in what a frame's loss says that was aligned with this read-out time.
  void update(const LossByReadout& loss, double readout_s);

 private:
  double information_;  ///< 1/s^2
  double weighted_;     ///< information times its best time, 1/s
};

}  // namespace vo
