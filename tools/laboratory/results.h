#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tools/laboratory/student_t.h"
#include "tools/scenario/run_scenario.h"

namespace tools {

struct ScenarioReport;

enum class ProblemKind {
  unusable,   ///< scenario, scene or place to write
  temporary,  ///< disk full
  tracker     ///< the outside program failed
};

/// One scenario with one seed.
struct TrialResult {
  int seed = 0;          ///< 0 is the scenario as its file says
  std::string sequence;  ///< hash of the files of the sequence that was tracked
  std::size_t frames = 0;
  Metrics metrics;      ///< NaN where nothing was measured
  std::string problem;  ///< one sentence on why nothing was measured; mostly empty
  std::string note;     ///< what should be known beside the result; mostly empty
  ProblemKind kind = ProblemKind::unusable;      ///< of the problem. In no file, as what follows
  bool was_kept = false;                         ///< measured by an earlier run of the same program
  double time = 0;                               ///< s, diagnostic
  std::shared_ptr<const ScenarioReport> report;  ///< where it was asked for
};

enum class Verdict {
  passed,
  failed,  ///< a bound does not hold
  error    ///< it could not be measured
};

std::string to_text(Verdict verdict);

struct ScenarioResult {
  std::string name;
  std::string why;
  std::vector<TrialResult> trials;  ///< by seed; one with a problem where the file is unusable
  std::vector<BoundCheck> checks;   ///< of the means over the seeds

  Verdict verdict() const;
  double time() const;  ///< s, of all trials
};

struct TestResults {
  std::string edvo;     ///< version
  std::string tracker;  ///< "edvo" or the command of an outside program
  std::vector<ScenarioResult> scenarios;

  bool passed() const;
};

/// The values of one metric over the trials without a problem, in the order of their seeds.
std::vector<double> values_of(const ScenarioResult& scenario, const std::string& metric);

/// Every metric with its mean over the seeds and 95 % confidence interval.
std::vector<std::pair<std::string, Estimate>> estimate_metrics(const ScenarioResult& scenario);

/// Judges the means over the trials.
std::vector<BoundCheck> check_means(const ScenarioResult& scenario,
                                    const std::map<std::string, Bound>& expect);

/// `ate_rmse_m is 0.012, expected <= 0.01`.
std::string violation_text(const BoundCheck& check);

/// Every problem and every violation of a scenario, one sentence each.
std::vector<std::string> complaints(const ScenarioResult& scenario);

}  // namespace tools
