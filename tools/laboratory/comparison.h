#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/laboratory/results.h"

namespace tools {

/// Thresholds that make a change between two results an alarm: it is both significant and large.
struct ComparisonOptions {
  double level = 0.01;  ///< family-wise error rate: probability of any false alarm in a comparison
  double worse_percent = 10;   ///< a metric that is worse by more than this is a large change
  double better_percent = 30;  ///< a metric that is better, or merely different, by more is too

  void validate() const;  ///< throws vo::Error on an invalid option
};

template <typename Visitor>
void visit_fields(Visitor& visit, ComparisonOptions& options) {
  visit("level", options.level, "probability of any false alarm over all comparisons");
  visit("worse_percent", options.worse_percent, "a metric that is worse by more is an alarm");
  visit("better_percent", options.better_percent, "and one that is better by more");
}

enum class ChangeKind { none, worse, better, different };

std::string to_text(ChangeKind kind);

/// Stands for the name of a scenario where all are compared together.
inline constexpr const char* kAllScenarios = "all scenarios";

/// One metric of one scenario, or of all together, compared between two results.
struct Change {
  std::string scenario;  ///< its name, or kAllScenarios
  std::string metric;
  double before = 0;  ///< mean over the seeds of the earlier result; NaN = not measured
  double after = 0;
  double percent = 0;        ///< relative change from before to after, %
  double p_value = 1;        ///< p-value of the null hypothesis that nothing changed
  double least_p_value = 0;  ///< smallest p-value that so many seeds can have
  ChangeKind kind = ChangeKind::none;
  bool is_significant = false;
  bool is_large = false;
  bool has_too_few_seeds = false;  ///< no difference between so few seeds would be significant
  std::string note;                ///< further remark, usually empty

  bool is_alarm() const { return is_significant && is_large; }
};

/// Returns one line such as `room_orbit: ate_rmse_m was 0.0038, is 0.0076 (+100 %, p 0.0001):
/// worse`.
std::string describe(const Change& change);

/// Compares every metric of the scenarios in both results, over the seeds that both have or, if
/// there are none, as independent samples, by `test_difference`. Where another share of the seeds
/// has a metric, the share is tested as well (Fisher's exact test), and the change reports the
/// worse of the two; a metric that no seed has any more is significant without a test. Error
/// metrics are compared over the paired trials of all scenarios together as well, by their
/// logarithms: scenarios of several seeds that both results have. Holm's correction over all these
/// hypotheses bounds the probability of any false alarm. Metrics that the earlier results do not
/// know are not compared. A single pair of trials gives no variance: tracker and sequence are taken
/// for deterministic, so every difference is significant.
std::vector<Change> compare_results(const TestResults& before, const TestResults& after,
                                    const ComparisonOptions& options);

/// Returns the scenarios that both results have, in the order of the later ones.
std::vector<std::pair<const ScenarioResult*, const ScenarioResult*>> common_scenarios(
    const TestResults& before, const TestResults& after);

/// Returns a sentence on each alarm of a scenario, or of all together (kAllScenarios).
std::vector<std::string> alarms_of(const std::string& scenario, const std::vector<Change>& changes);

/// Returns whether a change is an alarm.
bool has_alarm(const std::vector<Change>& changes);

/// Returns the names of the scenarios in `among` that `from` does not have.
std::vector<std::string> missing_scenarios(const TestResults& among, const TestResults& from);

/// Returns the results with the scenarios that only `old` has added, all sorted by name; of those
/// of one name, as of a file that was given twice, the first.
TestResults updated(const TestResults& old, const TestResults& results);

}  // namespace tools
