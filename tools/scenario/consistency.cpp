#include "tools/scenario/consistency.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

#include "vo/core/median.h"

namespace tools {
namespace {

constexpr double kMedianOfChi2 = 5.348121;  // median of chi^2 with six degrees of freedom

std::optional<double> squared_error(const vo::Trajectory& truth, const vo::TrackingResult& frame) {
  const auto T_world_ref = vo::pose_at(truth, frame.reference_timestamp);
  const auto T_world_cur = vo::pose_at(truth, frame.timestamp);
  if (frame.status != vo::TrackingStatus::tracked || !T_world_ref || !T_world_cur) {
    return {};
  }
  const vo::SE3 T_ref_cur_true = T_world_ref->inverse() * *T_world_cur;
  const vo::Vector6d error = (frame.alignment.T_cur_ref * T_ref_cur_true).log();
  return error.dot(frame.alignment.covariance.ldlt().solve(error));
}

}  // namespace

double nees_median(const vo::Trajectory& truth, const std::vector<vo::TrackingResult>& frames) {
  std::vector<double> squares;
  for (const vo::TrackingResult& frame : frames) {
    if (const std::optional<double> square = squared_error(truth, frame)) {
      squares.push_back(*square);
    }
  }
  if (squares.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return vo::upper_median(std::move(squares)) / kMedianOfChi2;
}

}  // namespace tools
