#include "vo/tracking/readout_estimate.h"

#include <algorithm>
#include <cmath>

namespace vo {
namespace {

constexpr double kMaxEstimate = 0.033;  // s, a frame's time at 30 Hz

/// Information of the first value, 1/s^2: a hundred times that of a standard deviation of 20 ms.
constexpr double kReadoutPriorInformation = 100 / (0.02 * 0.02);

/// Twice the fall of the loss from which on a read-out is not the noise of a global shutter's: ten
/// standard deviations, as neighbouring points err alike and overstate the information.
constexpr double kClear = 100;

/// A shorter read-out, s, is a global shutter's: the warp's other errors explain as much.
constexpr double kLeastReadout = 1e-3;

/// Returns the times along rows and along columns, s.
Eigen::Vector2d times_of(const Readout& readout) {
  return readout.axis == ReadoutAxis::rows ? Eigen::Vector2d(readout.seconds, 0)
                                           : Eigen::Vector2d(0, readout.seconds);
}

}  // namespace

ReadoutEstimate::ReadoutEstimate(const Readout& first)
    : first_(first),
      information_(kReadoutPriorInformation * Eigen::Matrix2d::Identity()),
      weighted_(information_ * times_of(first)) {}

Readout ReadoutEstimate::readout() const {
  const Eigen::Vector2d explained =  // twice by how much the loss is lower at each minimum
      weighted_.cwiseAbs2().cwiseQuotient(information_.diagonal());
  const Readout likely =
      along(explained[1] > explained[0] ? ReadoutAxis::columns : ReadoutAxis::rows);
  const bool is_clear = explained.maxCoeff() >= kClear && std::abs(likely.seconds) >= kLeastReadout;
  return is_clear || first_.is_rolling() ? likely : Readout();
}

Readout ReadoutEstimate::along(ReadoutAxis axis) const {
  const auto k = static_cast<Eigen::Index>(axis);
  return {std::clamp(weighted_[k] / information_(k, k), -kMaxEstimate, kMaxEstimate), axis};
}

Readout ReadoutEstimate::mapped() const {
  const Readout readout = along(first_.axis);
  const double forwards = first_.seconds < 0 ? -readout.seconds : readout.seconds;
  return forwards < kLeastMappedReadout ? Readout() : readout;
}

void ReadoutEstimate::update(const LossByReadout& loss, const Readout& used,
                             double curvature_share) {
  const Eigen::Matrix2d curvature = curvature_share * loss.curvature;
  information_ += curvature;
  weighted_ += curvature * times_of(used) - loss.slope;
}

}  // namespace vo
