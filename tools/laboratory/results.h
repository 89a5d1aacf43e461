#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tools/outside_tracker/problem_kind.h"
#include "tools/scenario/run_scenario.h"
#include "tools/statistics/significance.h"

namespace tools {

struct ScenarioReport;

/// The result of one scenario with one seed.
struct TrialResult {
  int seed = 0;          ///< 0 is the scenario as its file defines it
  std::string sequence;  ///< hash of the tracked sequence's files
  std::size_t frames = 0;
  Metrics metrics;      ///< NaN marks a metric that was not measured
  std::string problem;  ///< one sentence on why nothing was measured; empty on success
  std::string note;     ///< remark on this run for the terminal, usually empty; no file has it
  ProblemKind kind = ProblemKind::unusable;  ///< kind of the problem, if there is one
  bool was_kept = false;                     ///< taken from the cache of an earlier run; not stored
  double time = 0;                           ///< run time, s; diagnostic, not stored
  std::shared_ptr<const ScenarioReport> report;  ///< null unless requested; not stored
};

enum class Verdict {
  passed,
  failed,  ///< a bound is violated
  error    ///< a trial could not be measured
};

std::string to_text(Verdict verdict);

struct ScenarioResult {
  std::string name;
  std::string why;
  std::vector<TrialResult> trials;  ///< by seed; one with a problem if the file is unusable
  std::vector<BoundCheck> checks;   ///< bounds checked against the means over the seeds

  Verdict verdict() const;
  double time() const;  ///< total run time of all trials, s
};

/// What decides whether the measured metrics are good enough.
enum class BoundsSource {
  scenario,  ///< the bounds in the scenarios' `expect`, and a baseline if there is one
  baseline,  ///< a baseline alone: for trackers that the scenarios' bounds were not made for
  none       ///< nothing: metrics are only measured
};

constexpr auto enum_names(BoundsSource) {
  return std::array{std::pair{BoundsSource::scenario, "scenario"},
                    std::pair{BoundsSource::baseline, "baseline"},
                    std::pair{BoundsSource::none, "none"}};
}

struct TestResults {
  std::string edvo;                              ///< version of edvo
  std::string tracker;                           ///< "edvo" or the command of an external tracker
  BoundsSource bounds = BoundsSource::scenario;  ///< not stored in files
  std::vector<ScenarioResult> scenarios;
  std::set<std::string> unknown_metrics;  ///< metrics that the version of these results had not yet

  bool passed() const;
};

/// Returns the values of one metric over the trials without a problem, in seed order.
std::vector<double> values_of(const ScenarioResult& scenario, const std::string& metric);

/// Returns every metric's mean over the seeds with its 95 % confidence interval.
std::vector<std::pair<std::string, Estimate>> estimate_metrics(const ScenarioResult& scenario);

/// Checks the means over the trials against the bounds in `expect`.
std::vector<BoundCheck> check_means(const ScenarioResult& scenario,
                                    const std::map<std::string, Bound>& expect);

/// Returns a text such as `ate_rmse_m is 0.012, expected <= 0.01`.
std::string violation_text(const BoundCheck& check);

/// Returns every problem and every bound violation of a scenario, one sentence each.
std::vector<std::string> complaints(const ScenarioResult& scenario);

/// Returns the sentences as one, with semicolons between.
std::string joined(const std::vector<std::string>& sentences);

}  // namespace tools
