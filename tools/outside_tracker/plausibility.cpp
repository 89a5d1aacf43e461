#include "tools/outside_tracker/plausibility.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/core/median.h"
#include "vo/text_files/text_lines.h"

namespace tools {
namespace {

/// Returns the unit of the last digit of a number such as 1.25 (0.01) or 1.25e-3 (1e-5).
double last_digit_unit(std::string_view number) {
  constexpr double kBase = 10;
  const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  const double power = exponent < number.size() ? vo::parse_real(number.substr(exponent + 1)) : 0.0;
  return std::pow(kBase, power - static_cast<double>(decimals));
}

/// Returns how far the positions are from their centre, RMS, m.
double spread(const vo::Trajectory& trajectory) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const vo::StampedPose& pose : trajectory) {
    centre += pose.T_world_camera.translation() / static_cast<double>(trajectory.size());
  }
  double sum = 0;
  for (const vo::StampedPose& pose : trajectory) {
    sum += (pose.T_world_camera.translation() - centre).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(trajectory.size()));
}

}  // namespace

double position_unit(const std::filesystem::path& trajectory) {
  constexpr std::size_t kPositionEnd = 4;  // after the stamp and three coordinates
  std::vector<double> units;
  vo::TextFile(trajectory).for_each_line([&](const vo::TextLine& line) {
    for (std::size_t i = 1; i < kPositionEnd; ++i) {
      if (vo::parse_number(line, i) != 0) {
        units.push_back(last_digit_unit(line.fields[i]));
      }
    }
  });
  return units.empty() ? 0 : vo::upper_median(units);
}

std::string implausibility(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                           vo::TrajectoryAlignment alignment, const PositionUnits& units) {
  constexpr std::size_t kMinPoses = 3;
  if (estimate.size() < kMinPoses) {
    return "";
  }
  const vo::TrajectoryErrors errors = vo::evaluate(truth, estimate, {.alignment = alignment});
  const double unit = std::hypot(units.truth, errors.scale * units.estimate);
  const double expected = unit / 2;                   // m, RMS over positions
  const double greatest = std::sqrt(3.0) * unit / 2;  // m, of one position
  if (spread(truth) <= greatest) {
    return "";
  }
  if (errors.ate.rmse < expected) {
    return vo::concat("the tracker's trajectory is too good to be true: its ATE of ",
                      errors.ate.rmse, " m is below the rounding of its own numbers, ", expected,
                      " m");
  }
  if (errors.ate.max <= greatest) {
    return vo::concat(
        "the tracker's trajectory is too good to be true: all its positions are the "
        "true ones but for the rounding of its own numbers, ",
        greatest, " m");
  }
  return "";
}

}  // namespace tools
