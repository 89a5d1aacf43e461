#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"
#include "vo/core/progress.h"

namespace tools {

/// Returns how many of `comparisons` comparisons without a true difference raise an alarm: each
/// splits every scenario's trials at random into two halves and compares these as independent
/// samples. The comparisons are the steps of the progress. Throws vo::Error where a scenario has
/// fewer than four trials.
int count_false_alarms(const TestResults& results, int comparisons,
                       const ComparisonOptions& options, const vo::Progress& progress);

/// The numbers of seeds whose power is told.
inline constexpr std::array kPowerSeeds{2, 3, 5, 12};

/// Whether both results of a comparison have the same seeds.
enum class Seeds { same, other };

/// The growth of a metric that is an alarm in nine of ten comparisons.
struct DetectableChange {
  std::string scenario;
  std::size_t seeds = 0;  ///< number of seeds that the deviation was measured with
  double deviation = 0;   ///< of the logarithms between seeds or, of the same ones, of the changes
  std::array<double, kPowerSeeds.size()> percent{};  ///< by number of seeds; may be infinite
};

/// Simulates comparisons of a metric that spreads between seeds as in these results. With
/// `Seeds::same` its changes from `before` to `after` spread as they do here, with `Seeds::other`
/// both samples are independent. The hypotheses are as many as the two results give. Scenarios are
/// left out in which fewer than three seeds have the metric, or where it is not positive. Throws
/// vo::Error for an unknown metric.
std::vector<DetectableChange> detectable_changes(const TestResults& before,
                                                 const TestResults& after,
                                                 const std::string& metric, Seeds seeds,
                                                 const ComparisonOptions& options);

}  // namespace tools
