#pragma once

#include <string>
#include <vector>

#include "tools/laboratory/results.h"

namespace tools {

/// When a difference of two results is an alarm: it is no chance, and it is large.
struct ComparisonOptions {
  double level = 0.01;         ///< probability of any false alarm at all, over all comparisons
  double worse_percent = 10;   ///< a loss beyond this share of what it was is an alarm
  double better_percent = 30;  ///< a gain beyond this share, too: it mostly is a mistake

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, ComparisonOptions& options) {
  visit("level", options.level, "probability of any false alarm over all comparisons");
  visit("worse_percent", options.worse_percent, "a metric that is worse by more is an alarm");
  visit("better_percent", options.better_percent, "and one that is better by more");
}

enum class ChangeKind { none, worse, better, different };

std::string to_text(ChangeKind kind);

/// One metric of one scenario, in two results.
struct Change {
  std::string scenario;
  std::string metric;
  double before = 0;  ///< mean over the seeds; NaN = not measured
  double after = 0;
  double percent = 0;  ///< after over before, less 1
  double p_value = 1;  ///< of no change at all
  ChangeKind kind = ChangeKind::none;
  bool is_significant = false;
  bool is_large = false;
  std::string note;  ///< mostly empty

  bool is_alarm() const { return is_significant && is_large; }
};

/// `room_orbit: ate_rmse_m was 0.0038, is 0.0076 (+100 %, p 0.0001): worse`.
std::string describe(const Change& change);

/// Every metric of the scenarios that both have. Trials of the same seed are compared pairwise
/// (Student's test of the logarithms' differences), trials of other seeds as independent samples
/// (Welch's); over all of them Holm's correction keeps the probability of any false alarm. With a
/// single seed there is no chance to be seen: tracker and sequence are deterministic, and every
/// difference is significant.
std::vector<Change> compare_results(const TestResults& before, const TestResults& after,
                                    const ComparisonOptions& options);

/// The names of scenarios that only the first has.
std::vector<std::string> missing_scenarios(const TestResults& among, const TestResults& from);

}  // namespace tools
