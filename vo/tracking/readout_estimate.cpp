#include "vo/tracking/readout_estimate.h"

#include <algorithm>

namespace vo {
namespace {

constexpr double kStep = 0.003;        // s, of the central differences
constexpr double kMaxReadout = 0.033;  // s, a frame's time at 30 Hz

/// As much as a hundred times the least squares of one residual per 20 ms.
constexpr double kPriorInformation = 100 / (0.02 * 0.02);

}  // namespace

ReadoutEstimate::ReadoutEstimate(double first_s)
    : information_(kPriorInformation), weighted_(kPriorInformation * first_s) {}

double ReadoutEstimate::seconds() const {
  return std::clamp(weighted_ / information_, 0.0, kMaxReadout);
}

void ReadoutEstimate::update(std::span<const AlignReference> references,
                             const AlignCurrent& current, const SE3& T_cur_first,
                             const AlignOptions& options) {
  JointProblem problem(references, current, /*level=*/0, options);
  problem.match_brightness(T_cur_first);
  problem.estimate_scales(T_cur_first);
  const auto least_loss = [&](double readout) {
    problem.set_readout(readout);
    return problem.linearize(T_cur_first).least_loss();
  };
  const double before = least_loss(options.readout - kStep);
  const double here = least_loss(options.readout);
  const double after = least_loss(options.readout + kStep);
  const double slope = (after - before) / (2 * kStep);
  const double curvature = (after - 2 * here + before) / (kStep * kStep);
  if (curvature > 0) {
    information_ += curvature;
    weighted_ += curvature * options.readout - slope;
  }
}

}  // namespace vo
