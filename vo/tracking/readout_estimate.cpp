#include "vo/tracking/readout_estimate.h"

#include <algorithm>

namespace vo {
namespace {

constexpr double kMaxReadout = 0.033;  // s, a frame's time at 30 Hz

/// Information of the first value, 1/s^2: a hundred times that of a standard deviation of 20 ms.
constexpr double kReadoutPriorInformation = 100 / (0.02 * 0.02);

}  // namespace

ReadoutEstimate::ReadoutEstimate(double first_s)
    : information_(kReadoutPriorInformation), weighted_(kReadoutPriorInformation * first_s) {}

double ReadoutEstimate::seconds() const {
  return std::clamp(weighted_ / information_, 0.0, kMaxReadout);
}

void ReadoutEstimate::update(const LossByReadout& loss, double readout_s, double curvature_share) {
  const double curvature = curvature_share * loss.curvature;
  information_ += curvature;
  weighted_ += curvature * readout_s - loss.slope;
}

}  // namespace vo
