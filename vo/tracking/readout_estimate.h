#pragma once

#include <Eigen/Core>

#include "vo/alignment/align_result.h"
#include "vo/geometry/readout.h"

namespace vo {

/// Estimates the read-out of a rolling shutter while tracking: the one at which the frames agree
/// best. A wrong one bends every image that is taken in motion; 10 ms at 20 deg/s is 1.7 px between
/// the first and the last row of a Kinect's image.
///
/// Every frame gives the derivatives of its minimal cost by the read-out times along rows and along
/// columns. Their quadratic models are summed, starting from a prior that holds the read-out at its
/// first value. A sensor reads rows or columns, never both: the estimate is the minimum along the
/// axis whose minimum is lower. Where no first value is given, the shutter is global until the
/// frames clearly say otherwise.
class ReadoutEstimate {
 public:
  explicit ReadoutEstimate(const Readout& first);

  Readout readout() const;

  /// Returns the minimum along one axis, as if it were known that the shutter reads these lines.
  Readout along(ReadoutAxis axis) const;

  /// Returns the read-out to use where depths were found with the same read-out, which they absorb
  /// most of: along the lines of the first value, not against it, and long enough to be clear.
  Readout mapped() const;

  /// Adds the loss of a frame that was aligned with this read-out. `curvature_share` is the share
  /// of the loss's curvature that is left when the points' depths follow the read-out time.
  void update(const LossByReadout& loss, const Readout& used, double curvature_share = 1);

 private:
  Readout first_;
  Eigen::Matrix2d information_;  ///< 1/s^2
  Eigen::Vector2d weighted_;     ///< information times the estimate, 1/s
};

}  // namespace vo
